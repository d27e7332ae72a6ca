//@ part | needs quotient
// Arcs of a sine of at most 1/2.

// arcsin(s) = s + s z tail(z), z = s^2: minimax.
static inline real pelage_arc_sine_tail(real z) {
#ifdef PELAGE_DOUBLE
    real p = R(0x1.0b45ea63b1699p-5);
    p = fma(p, z, R(-0x1.57fad21f83513p-6));
    p = fma(p, z, R(0x1.639a8a1bbdd02p-6));
    p = fma(p, z, R(0x1.e5fbe63872ca6p-9));
    p = fma(p, z, R(0x1.613c1e9096db8p-7));
    p = fma(p, z, R(0x1.75859da822552p-7));
    p = fma(p, z, R(0x1.ca1f8af264013p-7));
    p = fma(p, z, R(0x1.1c49f077d2818p-6));
    p = fma(p, z, R(0x1.6e8bdedebfb72p-6));
    p = fma(p, z, R(0x1.f1c71a95002f6p-6));
    p = fma(p, z, R(0x1.6db6db721247bp-5));
    p = fma(p, z, R(0x1.333333332e133p-4));
    p = fma(p, z, R(0x1.5555555555577p-3));
#else
    real p = R(0x1.33d432p-5f);
    p = fma(p, z, R(0x1.d7924cp-7f));
    p = fma(p, z, R(0x1.04af34p-5f));
    p = fma(p, z, R(0x1.6caab6p-5f));
    p = fma(p, z, R(0x1.33389ep-4f));
    p = fma(p, z, R(0x1.55554cp-3f));
#endif
    return p;
}

// The arc is high + low. From 1/2 on it is half the angle between the arc of `size` and pi/2: its sine is
// sqrt((1 - size) / 2).
static inline struct pelage_pair pelage_arc_sine(real size, mask beyond) {
    const real halved = fma(R(-0.5f), size, R(0.5f));  // exact
    const real z = SELECT(beyond, halved, size * size);
    struct pelage_pair square;
    square.high = halved;
    square.low = R(0);
    const struct pelage_pair root = pelage_root(square);
    struct pelage_pair arc;
    arc.high = SELECT(beyond, root.high, size);
    arc.low = fma(arc.high, z * pelage_arc_sine_tail(z), SELECT(beyond, root.low, R(0)));
    return arc;
}
