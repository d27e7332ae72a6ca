// Number types and masks for every kernel; comes first in every program.
//   PELAGE_DOUBLE      scalar is double, else float
//   PELAGE_FAST        the compiler may contract and reorder; equality with the reference is given up
//   PELAGE_WIDTH       lanes of `real`: cells that one work-item handles side by side; default 1
//   PELAGE_PUBLISHED   arithmetic of the published program, else ours with fma (see core/lattice.hpp)

#ifdef PELAGE_FAST
#pragma OPENCL FP_CONTRACT ON
#else
#pragma OPENCL FP_CONTRACT OFF
#endif

#ifdef PELAGE_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define PELAGE_SCALAR double
#define PELAGE_LANE_MASK long
#else
#define PELAGE_SCALAR float
#define PELAGE_LANE_MASK int
#endif

#ifndef PELAGE_WIDTH
#define PELAGE_WIDTH 1
#endif

#define PELAGE_PASTE_(a, b) a##b
#define PELAGE_PASTE(a, b) PELAGE_PASTE_(a, b)

// Truth of one scalar that is neither NaN nor infinite. Bits are tested, for a compiler that may assume finite
// arithmetic (PELAGE_FAST) answers the built-in question without a look.
#ifdef PELAGE_DOUBLE
#define IS_FINITE(v) ((as_ulong(v) & 0x7ff0000000000000ul) != 0x7ff0000000000000ul)
#else
#define IS_FINITE(v) ((as_uint(v) & 0x7f800000u) != 0x7f800000u)
#endif

// Loops over a work-item's own arrays: a GPU keeps these in registers only where such loops are unrolled whole.
#if PELAGE_WIDTH == 1
#define PELAGE_UNROLLED _Pragma("unroll")
#else
#define PELAGE_UNROLLED _Pragma("unroll 4")
#endif

// Loops over the lanes of the few vectors that reach past an edge: as vectors of vectors they would only take the
// compiler long.
#ifdef __clang__
#define PELAGE_ROLLED _Pragma("clang loop vectorize(disable) unroll(disable)")
#else
#define PELAGE_ROLLED _Pragma("unroll 1")
#endif

// The count of a loop in which work-items meet and which is entered at least once. PoCL writes what follows such a loop
// twice, once for when it is not entered, unless it sees that this cannot be.
#define AT_LEAST_ONCE(count) max(count, 1)

// real: one number a lane. mask: truth a lane, as comparisons of real give it; combine with & and |.
typedef PELAGE_SCALAR scalar;
#if PELAGE_WIDTH == 1
typedef scalar real;
typedef int mask;
typedef uint uintv;
typedef int intv;
#define ALL_TRUE 1
#define ANY(m) (m)
#define LOAD(p) (*(p))
#define STORE(v, p) (*(p) = (v))
#define LANES ((uint)0)
#define TO_REAL PELAGE_PASTE(convert_, PELAGE_SCALAR)
#define TO_MASK(i) (i)
#define TO_UINT(i) as_uint(i)
#else
typedef PELAGE_PASTE(PELAGE_SCALAR, PELAGE_WIDTH) real;
typedef PELAGE_PASTE(PELAGE_LANE_MASK, PELAGE_WIDTH) mask;
typedef PELAGE_PASTE(uint, PELAGE_WIDTH) uintv;
typedef PELAGE_PASTE(int, PELAGE_WIDTH) intv;
#define ALL_TRUE ((mask)(-1))
#define ANY(m) any(m)
#ifdef __clang__
// As vload and vstore, which PoCL makes slow: it takes the vectors apart.
#define PELAGE_LOOSE(type, element)                                                    \
    typedef type __attribute__((aligned(sizeof(element)))) PELAGE_PASTE(loose_, type); \
    PELAGE_ACCESS(type, element, global)                                               \
    PELAGE_ACCESS(type, element, local)                                                \
    PELAGE_ACCESS(type, element, private)
#define PELAGE_ACCESS(type, element, space)                                                           \
    static inline type __attribute__((overloadable)) LOAD(const space element* p) {                   \
        return *(const space PELAGE_PASTE(loose_, type)*)p;                                           \
    }                                                                                                 \
    static inline void __attribute__((overloadable)) STORE(type v, space element* p) {                \
        *(space PELAGE_PASTE(loose_, type)*)p = v;                                                    \
    }
PELAGE_LOOSE(real, scalar)
PELAGE_LOOSE(uintv, uint)
PELAGE_LOOSE(intv, int)
#else
#define LOAD(p) PELAGE_PASTE(vload, PELAGE_WIDTH)(0, p)
#define STORE(v, p) PELAGE_PASTE(vstore, PELAGE_WIDTH)(v, 0, p)
#endif
#ifdef __clang__  // the same, in one instruction
#define TO_REAL(i) __builtin_convertvector(i, real)
#define TO_MASK(i) __builtin_convertvector(i, mask)
#else
#define TO_REAL(i) PELAGE_PASTE(PELAGE_PASTE(convert_, PELAGE_SCALAR), PELAGE_WIDTH)(i)
#define TO_MASK(i) PELAGE_PASTE(PELAGE_PASTE(convert_, PELAGE_LANE_MASK), PELAGE_WIDTH)(i)
#endif
#define TO_UINT(i) PELAGE_PASTE(as_uint, PELAGE_WIDTH)(i)
#if PELAGE_WIDTH == 2
#define LANES ((uintv)(0, 1))
#elif PELAGE_WIDTH == 4
#define LANES ((uintv)(0, 1, 2, 3))
#elif PELAGE_WIDTH == 8
#define LANES ((uintv)(0, 1, 2, 3, 4, 5, 6, 7))
#else
#define LANES ((uintv)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))
#endif
#endif
#define ALL_FALSE ((mask)(0))

// Whole numbers that rules read, from 0 to 2^32 - 1, as comparisons take them: exactly. The others are
// the kernel's: WHOLE_NEIGHBOURS, WHOLE_AGE, WHOLE_BIRTH, WHOLE_COLUMN; and, the same in all lanes and so scalars,
// WHOLE_ROW, WHOLE_LAYER, WHOLE_ROWS, WHOLE_COLUMNS, WHOLE_LAYERS.
#define WHOLE_ITERATION ((uint)(iteration))
#define W(n) ((uintv)(n))

// The time at an iteration: at the begin of the phase, and the steps since.
#define GET_TIME (time_start + TO_REAL((uintv)(iteration - time_begin)) * dt)

// The same truth in every lane; b is a scalar.
#define UNIFORM(b) ((b) ? ALL_TRUE : ALL_FALSE)

// A number in every lane; x is a scalar.
#define R(x) ((real)(x))

// A whole number of the buffer `parameters`, in which every number takes the room of a scalar.
#define PARAMETER_WORD(place) (((const global uint*)parameters)[(place) * (sizeof(scalar) / sizeof(uint))])

// Per lane: where the mask holds a, else b.
#define SELECT(m, a, b) ((m) ? (a) : (b))

// Held between two bounds, low <= high; a NaN stays one. In this form a compiler sees a minimum and a maximum.
static inline real pelage_held_below(real v, real high) { return SELECT(v > high, high, v); }
#define HELD(v, low, high) pelage_held_below(SELECT((v) < (low), low, v), high)
