// One iteration of PELAGE_WIDTH free cells: rules, then what the neighbours do, then bounds.
// Lines that begin with //@ are filled in with text emitted for the experiment (host/opencl/cells/source.cpp).

#if PELAGE_WIDTH == 1
#define COUNT(m) (m)
#else
#define COUNT(m) (-PELAGE_PASTE(convert_int, PELAGE_WIDTH)(m))
#endif
#define AS_INTV PELAGE_PASTE(as_int, PELAGE_WIDTH)
#define AS_UINTV PELAGE_PASTE(as_uint, PELAGE_WIDTH)
#if PELAGE_WIDTH == 1
#undef AS_INTV
#undef AS_UINTV
#define AS_INTV as_int
#define AS_UINTV as_uint
#endif

static inline int pelage_largest(intv v) {
    int lanes[PELAGE_WIDTH];
    STORE(v, lanes);
    int largest = lanes[0];
    for (int lane = 1; lane < PELAGE_WIDTH; ++lane) largest = max(largest, lanes[lane]);
    return largest;
}

// The lanes whose cells divide leave word for pelage_cells_append_children.
static inline int pelage_divide(mask where, real angle, int nth, int first, int n, int pitch, __global const int* id,
                         __global uint* divides, __global scalar* degrees) {
    int acts[PELAGE_WIDTH];
    scalar angles[PELAGE_WIDTH];
    STORE(COUNT(where), acts);
    STORE(angle, angles);
    int children = 0;
    for (int lane = 0; lane < PELAGE_WIDTH && first + lane < n; ++lane) {
        if (!acts[lane]) continue;
        const int cell = id[first + lane];
        divides[cell] |= 1u << nth;
        degrees[(long)nth * pitch + cell] = angles[lane];
        ++children;
    }
    return children;
}

#define MAY_DIVIDE(where) ((where) & may_divide)
#define DIVIDE(nth, rule, where, angle)                                                                        \
    if (ANY(MAY_DIVIDE(where))) {                                                                              \
        children += pelage_divide(MAY_DIVIDE(where), angle, nth, first, n, pitch, id_old, divides, degrees);   \
    }
#define MOVE(where, distance)                                 \
    {                                                         \
        const real offset = distance;                         \
        new_x = SELECT(where, new_x + px * offset, new_x);    \
        new_y = SELECT(where, new_y + py * offset, new_y);    \
    }
#define WHOLE_NEIGHBOURS TO_UINT(LOAD(neighbours_old + first))
#define WHOLE_BIRTH TO_UINT(LOAD(birth_old + first))
#define WHOLE_AGE ((uintv)(iteration)-WHOLE_BIRTH)
#define WHOLE_ROW 0u
#define WHOLE_COLUMN W(0)
#define WHOLE_ROWS 0u
#define WHOLE_COLUMNS 0u
#define GET_X x
#define GET_Y y

// Cells first .. first + PELAGE_WIDTH - 1. Returns how many children they ask for; `strayed`: which of them are now too
// far from where their lists were built. No `restrict`: Oclgrind 21.10 cannot inline it.
static inline int pelage_cells_advance(int first, int n, int pitch, PELAGE_CELL_ARRAYS(const, _old, ),
                                       PELAGE_CELL_ARRAYS(, _new, ), __global const scalar* built,
                                       __global const int* lengths, __global const int* lists, int capacity,
                                       scalar half_width, scalar half_height, __global uint* divides,
                                       __global scalar* degrees, scalar longest_way,
                                       __global const scalar* parameters, uint iteration, mask* strayed) {
    const real x = LOAD(position_old + first);
    const real y = LOAD(position_old + pitch + first);
    const intv self = (intv)(first) + AS_INTV(LANES);
    real new_x = x;
    real new_y = y;
    int children = 0;
    //@ LOAD
    {
        //@ RULES
        //@ MAPPINGS
        const intv length = LOAD(lengths + first);
        const int most = pelage_largest(length);
        const mask loose = TO_MASK(LOAD(fixed_old + first) == 0);
        __global const int* restrict list = lists + (long)(first & ~15) * capacity + (first & 15);
        intv count = 0;
        for (int k = 0; k < most; ++k) {
            const intv listed = (intv)(k) < length;
            const intv other = SELECT(listed, LOAD(list + (long)k * 16), self);
            const real dx = GATHER(position_old, other) - x;
            const real dy = GATHER(position_old + pitch, other) - y;
            const real square = dx * dx + dy * dy;
#ifdef PELAGE_ALL_LISTED
            const mask near = TO_MASK(listed);
#else
            const mask near = TO_MASK(listed) & (square < R(9));
#endif
            count += COUNT(near);
            const real norm = sqrt(square);
            //@ NEIGHBOUR
            const mask overlap = near & loose & (R(0) < norm) & (norm < R(2));
            if (ANY(overlap)) {
                const real weight = R((scalar)0.25) - R((scalar)0.5) / norm;
                new_x = SELECT(overlap, new_x + weight * dx, new_x);
                new_y = SELECT(overlap, new_y + weight * dy, new_y);
            }
        }
        STORE(count, neighbours_new + first);
        //@ FINISH
    }
    new_x = SELECT(new_x < R(-half_width), R(-half_width), SELECT(new_x > R(half_width), R(half_width), new_x));
    new_y = SELECT(new_y < R(-half_height), R(-half_height), SELECT(new_y > R(half_height), R(half_height), new_y));
    STORE(new_x, position_new + first);
    STORE(new_y, position_new + pitch + first);
    const real way_x = new_x - LOAD(built + first);
    const real way_y = new_y - LOAD(built + pitch + first);
    *strayed = (way_x * way_x + way_y * way_y > R(longest_way)) & TO_MASK(self < (intv)(n));
    return children;
}
