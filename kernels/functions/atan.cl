//@ function atan x | needs arc
static inline real pelage_atan(real x) {
    x = pelage_flushed(x);
    const real size = pelage_size(x);
    const mask steep = size > R(1);
    const real held = SELECT(size > R(0x1p60f), R(0x1p60f), size);
    const struct pelage_ratio ratio = pelage_ratio(SELECT(steep, R(1), size), R(1), SELECT(steep, held, R(1)));
    const bitsv down = SELECT(steep, SIGN_BIT, WORD(0u, 0ul));
    const real arc = pelage_arc_from(SELECT(steep, R(1), R(0)), ratio, down);
    return SELECT(size < PICK(0x1p-12f, 0x1p-27), x, pelage_signed(arc, pelage_sign(x)));
}
