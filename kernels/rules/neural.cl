// A neural reaction, see core/neural.hpp. The weights stand one block of hidden values after the other: for each block its
// biases, then its weights chemical by chemical, then those with which it adds to the sums, again chemical by chemical.
// Needs common/four.cl and functions/quick_sigmoid.cl.

#define PELAGE_BLOCK_OF_HIDDEN 8

#ifdef __clang__
#define PELAGE_NETWORK static inline __attribute__((always_inline))
#else
#define PELAGE_NETWORK static inline
#endif

// z[k] += x w[k] of a block of hidden values.
PELAGE_NETWORK void pelage_ask_block(const real x, global const scalar* w, real* z) {
#pragma unroll
    for (int k = 0; k < PELAGE_BLOCK_OF_HIDDEN; k += 4) {
        FETCH_FOUR(four, w + k);
        z[k] = fma(x, FOURTH(four, w + k, 0), z[k]);
        z[k + 1] = fma(x, FOURTH(four, w + k, 1), z[k + 1]);
        z[k + 2] = fma(x, FOURTH(four, w + k, 2), z[k + 2]);
        z[k + 3] = fma(x, FOURTH(four, w + k, 3), z[k + 3]);
    }
}

// sum + z[0] w[0] + z[1] w[1] ...
PELAGE_NETWORK real pelage_answer_block(const real* z, global const scalar* w, real sum) {
#pragma unroll
    for (int k = 0; k < PELAGE_BLOCK_OF_HIDDEN; k += 4) {
        FETCH_FOUR(four, w + k);
        sum = fma(z[k], FOURTH(four, w + k, 0), sum);
        sum = fma(z[k + 1], FOURTH(four, w + k, 1), sum);
        sum = fma(z[k + 2], FOURTH(four, w + k, 2), sum);
        sum = fma(z[k + 3], FOURTH(four, w + k, 3), sum);
    }
    return sum;
}

// f = act(x W0 + b0) W1. Every sum goes on with fma, in the order of the chemicals or of the hidden values.
PELAGE_NETWORK void pelage_network(const int chemicals, const int hidden, global const scalar* w, const real* x, real* f) {
    PELAGE_UNROLLED for (int i = 0; i < chemicals; ++i) f[i] = R(0);
    for (int h = 0; h < hidden; h += PELAGE_BLOCK_OF_HIDDEN) {
        real z[PELAGE_BLOCK_OF_HIDDEN];
#pragma unroll
        for (int k = 0; k < PELAGE_BLOCK_OF_HIDDEN; ++k) z[k] = R(w[k]);
        w += PELAGE_BLOCK_OF_HIDDEN;
        PELAGE_UNROLLED for (int i = 0; i < chemicals; ++i) {
            pelage_ask_block(x[i], w, z);
            w += PELAGE_BLOCK_OF_HIDDEN;
        }
#pragma unroll
        for (int k = 0; k < PELAGE_BLOCK_OF_HIDDEN; ++k) z[k] = z[k] * pelage_quick_sigmoid(R(5) * z[k]);
        PELAGE_UNROLLED for (int i = 0; i < chemicals; ++i) {
            f[i] = pelage_answer_block(z, w, f[i]);
            w += PELAGE_BLOCK_OF_HIDDEN;
        }
    }
}
