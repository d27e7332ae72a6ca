// Chemicals 2i and 2i + 1 of a cell lie side by side, so that one access fetches both from a neighbour; the last of an odd
// number lies alone. All at an even place begin where PLANE_OF says.

typedef PELAGE_PASTE(PELAGE_SCALAR, 2) pelage_pair;

#define PAIRS(p) ((global const pelage_pair*)(p))

// The chemicals u and v of the cells at `first` and after it, in `p`; the same of the cells at the places j; and back.
#if PELAGE_WIDTH == 1
#define LOAD_PAIR(u, v, p, first)                 \
    const pelage_pair u##_pair = PAIRS(p)[first]; \
    const real u = u##_pair.x, v = u##_pair.y;
#define GATHER_PAIR(u, v, p, j) LOAD_PAIR(u, v, p, j)
// One by one: Oclgrind takes a vector that is stored apart, and then says that parts of it were never set.
#define STORE_PAIR(u, v, p, first) \
    {                              \
        (p)[2L * (first)] = u;     \
        (p)[2L * (first) + 1] = v; \
    }
#else
#if PELAGE_WIDTH == 2
#define PELAGE_HALF_AT(a, j) (a)[j]
#elif PELAGE_WIDTH == 4
#define PELAGE_HALF_AT PELAGE_AT_2
#elif PELAGE_WIDTH == 8
#define PELAGE_HALF_AT PELAGE_AT_4
#else
#define PELAGE_HALF_AT PELAGE_AT_8
#endif
#define PELAGE_APART(u, v, left, right)                  \
    const real u##_left = left, u##_right = right;       \
    const real u = (real)(u##_left.even, u##_right.even); \
    const real v = (real)(u##_left.odd, u##_right.odd);
#define LOAD_PAIR(u, v, p, first) PELAGE_APART(u, v, LOAD((p) + 2L * (first)), LOAD((p) + 2L * (first) + PELAGE_WIDTH))
#define GATHER_PAIR(u, v, p, j) \
    PELAGE_APART(u, v, (real)(PELAGE_HALF_AT(PAIRS(p), j.lo)), (real)(PELAGE_HALF_AT(PAIRS(p), j.hi)))
#define STORE_PAIR(u, v, p, first)                      \
    {                                                   \
        real left, right;                               \
        left.even = u.lo, left.odd = v.lo;              \
        right.even = u.hi, right.odd = v.hi;            \
        STORE(left, (p) + 2L * (first));                \
        STORE(right, (p) + 2L * (first) + PELAGE_WIDTH); \
    }
#endif

// Of a chemical that lies alone.
#define LOAD_ALONE(u, p, first) const real u = LOAD((p) + (first));
#define GATHER_ALONE(u, p, j) const real u = GATHER(p, j);
