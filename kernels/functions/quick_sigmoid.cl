//@ part | needs power, quotient
// 1 / (1 + e^-x) in a third of the time of sigmoid.cl, to 4 units of the last place from -40 upward; below it stays what
// it is at -40, 4e-18: what a network asks of every hidden value.
static inline real pelage_quick_sigmoid(real x) {
    const real u = -HELD(x, R(-40), R(40));
    const real k = NEAREST(u * PICK(0x1.715476p+0f, 0x1.71547652b82fep+0));
    const real r = fma(-k, LN2_LOW, fma(-k, LN2_HIGH, u));
    const real power = (R(1) + fma(r * r, pelage_power_tail(r), r)) * pelage_power_of_two(k);
    return pelage_quick_reciprocal(R(1) + power);
}
