//@ function tan x | needs turn, quotient
static inline real pelage_tan(real x) {
    x = pelage_flushed(x);
    const struct pelage_angle angle = pelage_angle(pelage_size(x));
    const mask odd = IS_ODD(angle.quarters);
    const bitsv sign = pelage_sign(angle.sine.high);
    struct pelage_pair sine, above, below;
    sine.high = pelage_signed(angle.sine.high, sign);
    sine.low = pelage_signed(angle.sine.low, sign);
    above.high = SELECT(odd, angle.cosine.high, sine.high);
    above.low = SELECT(odd, angle.cosine.low, sine.low);
    below.high = SELECT(odd, sine.high, angle.cosine.high);
    below.low = SELECT(odd, sine.low, angle.cosine.low);
    const struct pelage_pair found = pelage_quotient(above, below);
    const bitsv turned = SELECT(odd, SIGN_BIT, WORD(0u, 0ul));
    const real steep = pelage_signed(found.high + found.low, (sign ^ turned) ^ pelage_sign(x));
    return SELECT(pelage_size(x) < PICK(0x1p-13f, 0x1p-28), x, steep);
}
