// A neural reaction, see core/neural.hpp. The weights stand one block of hidden values after the other: for each block its
// biases, then its weights chemical by chemical, then those with which it adds to the sums, again chemical by chemical.
// Needs functions/quick_sigmoid.cl.

#define PELAGE_BLOCK_OF_HIDDEN 8

#ifdef __clang__
#define PELAGE_NETWORK static inline __attribute__((always_inline))
#else
#define PELAGE_NETWORK static inline
#endif

// f = act(x W0 + b0) W1. Every sum goes on with fma, in the order of the chemicals or of the hidden values.
PELAGE_NETWORK void pelage_network(const int chemicals, const int hidden, global const scalar* w, const real* x, real* f) {
    for (int i = 0; i < chemicals; ++i) f[i] = R(0);
    for (int h = 0; h < hidden; h += PELAGE_BLOCK_OF_HIDDEN) {
        real z[PELAGE_BLOCK_OF_HIDDEN];
#pragma unroll
        for (int k = 0; k < PELAGE_BLOCK_OF_HIDDEN; ++k) z[k] = R(w[k]);
        w += PELAGE_BLOCK_OF_HIDDEN;
#pragma unroll 4
        for (int i = 0; i < chemicals; ++i) {
#pragma unroll
            for (int k = 0; k < PELAGE_BLOCK_OF_HIDDEN; ++k) z[k] = fma(x[i], R(w[k]), z[k]);
            w += PELAGE_BLOCK_OF_HIDDEN;
        }
#pragma unroll
        for (int k = 0; k < PELAGE_BLOCK_OF_HIDDEN; ++k) z[k] = z[k] * pelage_quick_sigmoid(R(5) * z[k]);
#pragma unroll 4
        for (int i = 0; i < chemicals; ++i) {
            real sum = f[i];
#pragma unroll
            for (int k = 0; k < PELAGE_BLOCK_OF_HIDDEN; ++k) sum = fma(z[k], R(w[k]), sum);
            f[i] = sum;
            w += PELAGE_BLOCK_OF_HIDDEN;
        }
    }
}
