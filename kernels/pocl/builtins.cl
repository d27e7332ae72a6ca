// The built-in functions that our kernels call, declared as OpenCL C 1.2 declares them (sections 6.12.1 to 6.12.11).
// Clang's own header declares all there are, in 18,000 lines, and reading it takes PoCL ten times as long as compiling a
// small program. On PoCL this file stands before a program in the header's place; see opencl/device/pocl_header.hpp.

#define PELAGE_BUILTIN __attribute__((overloadable))
#define PELAGE_CONST __attribute__((overloadable, const))

size_t PELAGE_CONST get_global_id(uint);
size_t PELAGE_CONST get_global_size(uint);
size_t PELAGE_CONST get_global_offset(uint);
size_t PELAGE_CONST get_group_id(uint);
size_t PELAGE_CONST get_num_groups(uint);
size_t PELAGE_CONST get_local_id(uint);
size_t PELAGE_CONST get_local_size(uint);
uint PELAGE_CONST get_work_dim(void);

void __attribute__((overloadable, convergent)) barrier(cl_mem_fence_flags);
void PELAGE_BUILTIN mem_fence(cl_mem_fence_flags);
void PELAGE_BUILTIN read_mem_fence(cl_mem_fence_flags);
void PELAGE_BUILTIN write_mem_fence(cl_mem_fence_flags);

// M for each width of two types of vectors.
#define PELAGE_OF_WIDTHS(M, T, U) M(T, U) M(T##2, U##2) M(T##3, U##3) M(T##4, U##4) M(T##8, U##8) M(T##16, U##16)

// Whole numbers. U: the unsigned type of the same size.
#define PELAGE_WHOLE(T, U)       \
    U PELAGE_CONST abs(T);       \
    T PELAGE_CONST clz(T);       \
    T PELAGE_CONST popcount(T);  \
    T PELAGE_CONST mul_hi(T, T); \
    T PELAGE_CONST rotate(T, T); \
    T PELAGE_CONST min(T, T);    \
    T PELAGE_CONST max(T, T);    \
    T PELAGE_CONST clamp(T, T, T);
PELAGE_OF_WIDTHS(PELAGE_WHOLE, int, uint)
PELAGE_OF_WIDTHS(PELAGE_WHOLE, uint, uint)
PELAGE_OF_WIDTHS(PELAGE_WHOLE, long, ulong)
PELAGE_OF_WIDTHS(PELAGE_WHOLE, ulong, ulong)

// Vectors of V, bounds of one S for all lanes.
#define PELAGE_BOUND(V, S)    \
    V PELAGE_CONST min(V, S); \
    V PELAGE_CONST max(V, S); \
    V PELAGE_CONST clamp(V, S, S);
#define PELAGE_BOUNDS(T)                                                                    \
    PELAGE_BOUND(T##2, T) PELAGE_BOUND(T##3, T) PELAGE_BOUND(T##4, T) PELAGE_BOUND(T##8, T) \
    PELAGE_BOUND(T##16, T)
PELAGE_BOUNDS(int)
PELAGE_BOUNDS(uint)
PELAGE_BOUNDS(long)
PELAGE_BOUNDS(ulong)
PELAGE_BOUNDS(float)

// Truths.
#define PELAGE_TRUTH(T, U)   \
    int PELAGE_CONST any(T); \
    int PELAGE_CONST all(T);
PELAGE_OF_WIDTHS(PELAGE_TRUTH, int, int)
PELAGE_OF_WIDTHS(PELAGE_TRUTH, long, long)

// A choice between two of T by one of C.
#define PELAGE_CHOICE(T, C) T PELAGE_CONST select(T, T, C);
PELAGE_OF_WIDTHS(PELAGE_CHOICE, int, int)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, int, uint)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, uint, int)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, uint, uint)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, float, int)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, float, uint)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, long, long)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, long, ulong)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, ulong, long)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, ulong, ulong)

// Real numbers.
#define PELAGE_REAL(T, U)        \
    T PELAGE_CONST fma(T, T, T); \
    T PELAGE_CONST sqrt(T);      \
    T PELAGE_CONST fabs(T);      \
    T PELAGE_CONST floor(T);     \
    T PELAGE_CONST ceil(T);      \
    T PELAGE_CONST rint(T);      \
    T PELAGE_CONST trunc(T);     \
    T PELAGE_CONST fmin(T, T);   \
    T PELAGE_CONST fmax(T, T);   \
    T PELAGE_CONST min(T, T);    \
    T PELAGE_CONST max(T, T);    \
    T PELAGE_CONST clamp(T, T, T);
PELAGE_OF_WIDTHS(PELAGE_REAL, float, float)
#define PELAGE_REAL_BOUND(V, S) \
    V PELAGE_CONST fmin(V, S);  \
    V PELAGE_CONST fmax(V, S);
#define PELAGE_REAL_BOUNDS(T)                                                        \
    PELAGE_REAL_BOUND(T##2, T) PELAGE_REAL_BOUND(T##3, T) PELAGE_REAL_BOUND(T##4, T) \
    PELAGE_REAL_BOUND(T##8, T) PELAGE_REAL_BOUND(T##16, T)
PELAGE_REAL_BOUNDS(float)

// Conversions, from each of the types that we use to each.
#define PELAGE_CONVERSION(FROM, TO) TO PELAGE_CONST convert_##TO(FROM);
#define PELAGE_CONVERSIONS_FROM(T)                \
    PELAGE_OF_WIDTHS(PELAGE_CONVERSION, T, int)   \
    PELAGE_OF_WIDTHS(PELAGE_CONVERSION, T, uint)  \
    PELAGE_OF_WIDTHS(PELAGE_CONVERSION, T, long)  \
    PELAGE_OF_WIDTHS(PELAGE_CONVERSION, T, ulong) \
    PELAGE_OF_WIDTHS(PELAGE_CONVERSION, T, float)
PELAGE_CONVERSIONS_FROM(int)
PELAGE_CONVERSIONS_FROM(uint)
PELAGE_CONVERSIONS_FROM(long)
PELAGE_CONVERSIONS_FROM(ulong)
PELAGE_CONVERSIONS_FROM(float)

// Vectors in memory, in each space.
#define PELAGE_MEMORY_OF(T, N, SPACE)                                          \
    T##N __attribute__((overloadable, pure)) vload##N(size_t, const SPACE T*); \
    void PELAGE_BUILTIN vstore##N(T##N, size_t, SPACE T*);
#define PELAGE_MEMORY_IN(T, SPACE)                                                            \
    PELAGE_MEMORY_OF(T, 2, SPACE) PELAGE_MEMORY_OF(T, 3, SPACE) PELAGE_MEMORY_OF(T, 4, SPACE) \
    PELAGE_MEMORY_OF(T, 8, SPACE) PELAGE_MEMORY_OF(T, 16, SPACE)
#define PELAGE_MEMORY(T) PELAGE_MEMORY_IN(T, __global) PELAGE_MEMORY_IN(T, __local) PELAGE_MEMORY_IN(T, __private)
PELAGE_MEMORY(int)
PELAGE_MEMORY(uint)
PELAGE_MEMORY(long)
PELAGE_MEMORY(ulong)
PELAGE_MEMORY(float)

// What no other work-item can come between.
#define PELAGE_ATOMIC(T, SPACE)                         \
    T PELAGE_BUILTIN atomic_inc(volatile SPACE T*);     \
    T PELAGE_BUILTIN atomic_dec(volatile SPACE T*);     \
    T PELAGE_BUILTIN atomic_add(volatile SPACE T*, T);  \
    T PELAGE_BUILTIN atomic_sub(volatile SPACE T*, T);  \
    T PELAGE_BUILTIN atomic_and(volatile SPACE T*, T);  \
    T PELAGE_BUILTIN atomic_or(volatile SPACE T*, T);   \
    T PELAGE_BUILTIN atomic_min(volatile SPACE T*, T);  \
    T PELAGE_BUILTIN atomic_max(volatile SPACE T*, T);  \
    T PELAGE_BUILTIN atomic_xchg(volatile SPACE T*, T); \
    T PELAGE_BUILTIN atomic_cmpxchg(volatile SPACE T*, T, T);
PELAGE_ATOMIC(int, __global)
PELAGE_ATOMIC(int, __local)
PELAGE_ATOMIC(uint, __global)
PELAGE_ATOMIC(uint, __local)

#ifdef PELAGE_DOUBLE
PELAGE_BOUNDS(double)
PELAGE_REAL_BOUNDS(double)
PELAGE_OF_WIDTHS(PELAGE_REAL, double, double)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, double, long)
PELAGE_OF_WIDTHS(PELAGE_CHOICE, double, ulong)
PELAGE_CONVERSIONS_FROM(double)
PELAGE_OF_WIDTHS(PELAGE_CONVERSION, int, double)
PELAGE_OF_WIDTHS(PELAGE_CONVERSION, uint, double)
PELAGE_OF_WIDTHS(PELAGE_CONVERSION, long, double)
PELAGE_OF_WIDTHS(PELAGE_CONVERSION, ulong, double)
PELAGE_OF_WIDTHS(PELAGE_CONVERSION, float, double)
PELAGE_OF_WIDTHS(PELAGE_CONVERSION, double, double)
PELAGE_MEMORY(double)
#endif
