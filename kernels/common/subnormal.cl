// What a device makes of subnormal numbers, in results and in operands: see host/opencl/device/subnormal.cpp.

// in: two normal numbers whose sum is subnormal, two whose product is, 0, a subnormal number, 2^40.
kernel void pelage_subnormal(global const float* restrict in, global float* restrict out) {
    out[0] = in[0] + in[1];
    out[1] = in[2] * in[3];
    out[2] = fma(in[2], in[3], in[4]);
    out[3] = in[2] / in[6];
    out[4] = (in[0] + in[5]) - in[0];
    out[5] = in[5] * in[6];
    out[6] = fma(in[5], in[6], in[4]);
    out[7] = in[5] > in[4] ? 1.0f : 0.0f;
}
