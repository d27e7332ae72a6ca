// What a charge adds to a candidate's sum, and what weight a candidate has. As core/inverse_root.hpp and
// reference/aggregate/weight.hpp, bit for bit: no operation here is a fused one.

#pragma OPENCL FP_CONTRACT OFF

// A site's column and row in 15 bits each. A candidate whose sum is not known yet has the mark beside them; a place
// without a candidate has every bit.
#define NO_SITE 0xffffffffu
#define NEW_SITE 0x8000u
#define SITE(x, y) ((uint)(x) | (uint)(y) << 16)
#define SITE_X(site) ((int)((site) & 0x7fffu))
#define SITE_Y(site) ((int)((site) >> 16 & 0x7fffu))

// 1 / sqrt(d): a guess from the bits, and three of Newton's steps.
static inline float pelage_inverse_root(float d) {
    const float half_d = 0.5f * d;
    float y = as_float(0x5f375a86u - (as_uint(d) >> 1));
    y = y * (1.5f - (half_d * y) * y);
    y = y * (1.5f - (half_d * y) * y);
    return y * (1.5f - (half_d * y) * y);
}

// Size * 2^30 / r of the other one, rounded to a whole number. Where all charges have the size 1, an int holds it.
#if PELAGE_SIZES
#define TERM long
#define CONVERT_TERM convert_long
#define SIZED(parts, size) ((parts) * (size))
#else
#define TERM int
#define CONVERT_TERM convert_int
#define SIZED(parts, size) (parts)
#endif

static inline TERM pelage_term_at(float square, float size) {
    const float parts = SIZED(pelage_inverse_root(square) * 0x1p30f, size);
    return CONVERT_TERM(parts < 0x1p23f ? (parts + 0x1p23f) - 0x1p23f : parts);  // beyond there are whole ones alone
}

static inline TERM pelage_sized_term(uint one, uint other, float size) {
    const int x = SITE_X(one) - SITE_X(other);
    const int y = SITE_Y(one) - SITE_Y(other);
    return pelage_term_at(convert_float(x * x + y * y), size);
}

#if PELAGE_SIZES
#define pelage_term(one, other, size) pelage_sized_term(one, other, size)
#else
#define pelage_term(one, other, size) pelage_sized_term(one, other, 1.0f)  // `sizes` holds none
#endif

struct pelage_particle {  // struct DeviceParticle of opencl/aggregate/device.cpp
    float eta;
    float pull;
    float x, y;
    ulong draw;
    float size;
    float unused;
};

// What a place gives to the candidates near it.
static inline long pelage_pull(const struct pelage_particle particle, uint site) {
    const float x = convert_float(SITE_X(site)) - particle.x;
    const float y = convert_float(SITE_Y(site)) - particle.y;
    const float square = x * x + y * y;
    const float inverse = pelage_inverse_root(square < 1.0f ? 1.0f : square);
    return convert_long(particle.pull * inverse * 0x1p30f);
}

static inline long pelage_value(const struct pelage_particle particle, uint site, long sum) {
    return (particle.pull == 0.0f ? 0l : pelage_pull(particle, site)) - sum;
}

// ---- weights

#define FULL_WEIGHT (1ul << 38)

static inline float pelage_reciprocal(float d) {
    float y = as_float(0x7ef311c3u - as_uint(d));
    for (int i = 0; i < 4; ++i) y = y * (2.0f - d * y);
    return y;
}

static inline float pelage_binary_log(float x) {
    const uint bits = as_uint(x);
    const int exponent = as_int(bits - 0x3f3504f3u) >> 23;
    const float t = as_float(bits - (as_uint(exponent) << 23)) - 1.0f;
    float p = 0x1.01b6c6p-3f;
    p = p * t + -0x1.a87d02p-3f;
    p = p * t + 0x1.b9c91cp-3f;
    p = p * t + -0x1.e95be8p-3f;
    p = p * t + 0x1.26d384p-2f;
    p = p * t + -0x1.715c4ep-2f;
    p = p * t + 0x1.ec73d6p-2f;
    p = p * t + -0x1.71547p-1f;
    p = p * t + 0x1.715476p+0f;
    return p * t + convert_float(exponent);
}

// The bits of a power, -60 <= y <= 1.
static inline uint pelage_binary_power(float y) {
    const float shifted = y + 0x1.8p+23f;
    const float f = y - (shifted - 0x1.8p+23f);
    float p = 0x1.5c08e4p-10f;
    p = p * f + 0x1.3d0c52p-7f;
    p = p * f + 0x1.c6b6e4p-5f;
    p = p * f + 0x1.ebf918p-3f;
    p = p * f + 0x1.62e428p-1f;
    p = p * f + 0x1.000002p+0f;
    return as_uint(p) + (as_uint(shifted) << 23);
}

struct pelage_scale {
    long lowest;
    float eta;
    float scale;
    int down;
    int flat;  // all candidates weigh the same
};

static inline struct pelage_scale pelage_scale_of(long lowest, long highest, float eta) {
    struct pelage_scale made;
    const ulong range = (ulong)highest - (ulong)lowest;
    made.lowest = lowest;
    made.eta = eta;
    made.flat = range == 0ul || eta == 0.0f;
    made.down = max(0, 64 - (int)clz(range) - 31);
    made.scale = made.flat ? 0.0f : pelage_reciprocal(convert_float((int)(range >> made.down)));
    return made;
}

// How far a value lies above the lowest one, in 31 bits.
static inline int pelage_above(const struct pelage_scale scale, long value) {
    return (int)((ulong)(value - scale.lowest) >> (ulong)scale.down);
}

// The bits of what that weighs, as a float; 0: nothing.
static inline uint pelage_weight_bits(const struct pelage_scale scale, int above) {
    const float power = scale.eta * pelage_binary_log(convert_float(above) * scale.scale);
    const uint bits = pelage_binary_power(power < -60.0f ? -60.0f : power);
    return above == 0 ? 0u : bits;
}

// That in parts of 2^38, what is less than one part being cut off: the mantissa, shifted as the exponent says.
static inline ulong pelage_weight(uint bits) {
    const ulong mantissa = (ulong)((bits & 0x7fffffu) | 0x800000u);
    const int up = (int)(bits >> 23) - 112;
    const ulong weight = up < 0 ? mantissa >> (ulong)(-up & 63) : mantissa << (ulong)(up & 63);
    return bits == 0u ? 0ul : weight;
}
