//@ function hypot a, b | needs quotient
// As a square root of squares that neither overflow nor vanish.
static inline real pelage_hypot(real a, real b) {
    const real one = pelage_size(pelage_flushed(a));
    const real other = pelage_size(pelage_flushed(b));
    real more = SELECT(one < other, other, one);
    real less = SELECT(one < other, one, other);
    const mask infinite = (one == INFINITE) | (other == INFINITE);
    const mask large = more > PICK(0x1p+40f, 0x1p+500);
    const mask small = more < PICK(0x1p-40f, 0x1p-500);
    const real up = PICK(0x1p+80f, 0x1p+600);
    const real down = PICK(0x1p-80f, 0x1p-600);
    const real scale = SELECT(large, down, SELECT(small, up, R(1)));
    more = more * scale;
    less = pelage_flushed(less * scale);
    const struct pelage_pair square = pelage_product(more, more);
    const struct pelage_pair added = pelage_product(less, less);
    struct pelage_pair sum = pelage_quick_sum(square.high, pelage_flushed(added.high));
    sum.low += pelage_flushed(square.low) + pelage_flushed(added.low);
    const struct pelage_pair root = pelage_root(sum);
    const real found = (root.high + root.low) * SELECT(large, up, SELECT(small, down, R(1)));
    return SELECT(infinite, INFINITE, SELECT((a != a) | (b != b), a + b, found));
}
