// From partial sums to slopes of weights, and a step of the optimiser; see reference/learn/adam.hpp. Needs learn/sums.cl
// and functions/quotient.cl.

// sums: [run][weight][lane].
kernel void pelage_learn_total(global const scalar* restrict sums, const int runs, const int weights,
                               global scalar* restrict slopes) {
    const int weight = (int)get_global_id(0);
    if (weight >= weights) return;
    scalar lanes[PELAGE_LANES];
    for (int lane = 0; lane < PELAGE_LANES; ++lane) lanes[lane] = 0;
    for (int run = 0; run < runs; ++run) {
        global const scalar* own = sums + ((long)run * weights + weight) * PELAGE_LANES;
        for (int lane = 0; lane < PELAGE_LANES; ++lane) lanes[lane] = lanes[lane] + own[lane];
    }
    slopes[weight] = pelage_folded(lanes, PELAGE_LANES);
}

static inline real pelage_length_root(real square, real smallest) {
    if (square < smallest) return R(0);
    struct pelage_pair number;
    number.high = square;
    number.low = R(0);
    const struct pelage_pair found = pelage_root(number);
    return found.high + found.low;
}

static inline real pelage_over(real number, real divisor) {
    struct pelage_pair above, below;
    above.high = number;
    below.high = divisor;
    above.low = below.low = R(0);
    const struct pelage_pair found = pelage_quotient(above, below);
    return found.high + found.low;
}

// factors[n] brings the n-th of three arrays, which end at ends[n], to length 1; a group of PELAGE_LANES each.
kernel void pelage_learn_lengths(global const scalar* restrict slopes, const int4 ends, const scalar smallest_square,
                                 const scalar smallest_divisor, global scalar* restrict factors) {
    local scalar lanes[PELAGE_LANES];
    const int n = (int)get_group_id(0), lane = (int)get_local_id(0);
    const int begin = n == 0 ? 0 : n == 1 ? ends.s0 : ends.s1;
    const int end = n == 0 ? ends.s0 : n == 1 ? ends.s1 : ends.s2;
    scalar sum = 0;
    for (int at = begin + lane; at < end; at += PELAGE_LANES) sum = fma(slopes[at], slopes[at], sum);
    lanes[lane] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (lane != 0) return;
    const scalar length = pelage_length_root(pelage_folded_shared(lanes), smallest_square);
    factors[n] = pelage_over(R(1), length + smallest_divisor);
}

// numbers: decay and share of what is new of the mean, and of the square; the step's length, the square's scale, the
// smallest square and the smallest divisor.
kernel void pelage_learn_adam(global const scalar* restrict slopes, global const scalar* restrict factors,
                              const int4 ends, global const scalar* restrict numbers, global scalar* restrict weights,
                              global scalar* restrict means, global scalar* restrict squares) {
    const int n = (int)get_global_id(0);
    if (n >= ends.s2) return;
    const scalar slope = slopes[n] * factors[n < ends.s0 ? 0 : n < ends.s1 ? 1 : 2];
    means[n] = fma(numbers[0], means[n], numbers[1] * slope);
    squares[n] = fma(numbers[2], squares[n], numbers[3] * (slope * slope));
    const scalar divisor = pelage_length_root(numbers[5] * squares[n], numbers[6]) + numbers[7];
    weights[n] = weights[n] - pelage_over(numbers[4] * means[n], divisor);
}
