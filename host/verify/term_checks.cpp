// See check.hpp: what a charge adds to a sum, and what a candidate weighs, number by number. In a run the last digits
// of a weight show only where a draw lies between the right one and the wrong one.
#include "core/inverse_root.hpp"
#include "core/philox.hpp"
#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/program.hpp"
#include "reference/aggregate/weight.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pelage::verify {

namespace {

// As struct asked of the kernel has it.
struct Asked {
    std::int64_t lowest, highest, value;
    std::uint32_t one, other;  // sites, in 15 bits column and row
    float size, eta, number, share, power, unused;
};

constexpr const char* text = R"(
struct asked {
    long lowest, highest, value;
    uint one, other;
    float size, eta, number, share, power, unused;
};

kernel void pelage_check_terms(global const struct asked* all, global uint* out) {
    const size_t i = get_global_id(0);
    const struct asked this = all[i];
    global uint* const found = out + 8 * i;
    const ulong term = (ulong)pelage_term(this.one, this.other, this.size);
    const struct pelage_scale scale = pelage_scale_of(this.lowest, this.highest, this.eta);
    const ulong weight =
        scale.flat ? FULL_WEIGHT : pelage_weight(pelage_weight_bits(scale, pelage_above(scale, this.value)));
    found[0] = (uint)term;
    found[1] = (uint)(term >> 32);
    found[2] = (uint)weight;
    found[3] = (uint)(weight >> 32);
    found[4] = as_uint(pelage_inverse_root(this.number));
    found[5] = as_uint(pelage_reciprocal(this.number));
    found[6] = as_uint(pelage_binary_log(this.share));
    found[7] = pelage_binary_power(this.power);
}
)";
constexpr std::size_t words_of_one = 8;

// Potentials within few and many bits; numbers from 1 to 2^31, shares down to 2^-20, half of them about 1, where the
// digits of a logarithm are finest; powers from -60 to 1.
std::vector<Asked> drawn(std::size_t count, std::int64_t seed) {
    std::vector<Asked> all;
    for (std::size_t n = 0; n < count; ++n) {
        const auto a = counted_words(n, 0, 0, 21, seed), b = counted_words(n, 1, 0, 21, seed);
        const auto wide = static_cast<std::int64_t>(std::uint64_t{b[0]} << 30 >> (b[1] % 60));
        Asked one{};
        one.lowest = static_cast<std::int64_t>(a[0]) - (std::int64_t{1} << 31);
        one.highest = one.lowest + wide;
        const auto part = static_cast<double>(a[1]) * 0x1p-32;
        one.value = one.lowest + static_cast<std::int64_t>(part * static_cast<double>(wide));
        one.one = a[2] & 0x7fff7fffu;
        one.other = a[3] & 0x7fff7fffu;
        if (one.one == one.other) one.other ^= 1u;  // no site adds to itself
        one.size = std::exp2(unit_uniform<float>(b[2]) * 20.0f - 10.0f);
        one.eta = n % 9 == 0 ? 0.0f : unit_uniform<float>(b[3]) * 12.0f;
        one.number = std::exp2(unit_uniform<float>(a[1]) * 30.99f);
        one.share = std::exp2(unit_uniform<float>(b[0]) - (n % 2 == 0 ? 0.5f : 20.0f));
        one.power = unit_uniform<float>(a[0]) * 61.0f - 60.0f;
        all.push_back(one);
    }
    return all;
}

std::int64_t term_of(const Asked& one, bool sized) {
    const auto column = [](std::uint32_t site) { return static_cast<std::int32_t>(site & 0x7fffu); };
    const std::int32_t x = column(one.one) - column(one.other), y = column(one.one >> 16) - column(one.other >> 16);
    return inverse_parts_at(static_cast<float>(x * x + y * y), sized ? one.size : 1.0f);
}

std::vector<std::uint32_t> by_reference(const std::vector<Asked>& all, bool sized) {
    const SubnormalsAreZero scope;
    std::vector<std::uint32_t> words;
    for (const Asked& one : all) {
        const auto term = static_cast<std::uint64_t>(term_of(one, sized));
        const std::uint64_t weight = reference::Weights(one.lowest, one.highest, one.eta)(one.value);
        for (const std::uint64_t number : {term, weight}) {
            words.push_back(static_cast<std::uint32_t>(number));
            words.push_back(static_cast<std::uint32_t>(number >> 32));
        }
        for (const float number : {inverse_root(one.number), reference::reciprocal(one.number),
                                   reference::binary_log(one.share), reference::binary_power(one.power)})
            words.push_back(std::bit_cast<std::uint32_t>(number));
    }
    return words;
}

std::vector<std::uint32_t> on_device(const Session& on, const std::vector<Asked>& all, bool sized) {
    return with_device(on.info().name, [&] {
        Source source;
        source.text(fmt::format("#define PELAGE_SIZES {}\n", sized ? 1 : 0));
        source.file("common/prelude.cl").file("aggregate/terms.cl").text(text);
        cl::Kernel kernel(on.build(source.str()), "pelage_check_terms");
        const std::size_t words = words_of_one * all.size();
        const cl::Buffer asked = on.buffer(all.size() * sizeof(Asked), "arguments");
        const cl::Buffer out = on.buffer(words * sizeof(cl_uint), "terms and weights");
        on.queue().enqueueWriteBuffer(asked, CL_TRUE, 0, all.size() * sizeof(Asked), all.data());
        on.poison_buffer(out, words * sizeof(cl_uint));
        kernel.setArg(0, asked);
        kernel.setArg(1, out);
        on.launch(kernel, cl::NDRange(all.size()), cl::NDRange(1));
        std::vector<std::uint32_t> found(words);
        on.queue().enqueueReadBuffer(out, CL_TRUE, 0, words * sizeof(cl_uint), found.data());
        return found;
    });
}

Outcome check_terms(Place& place) {
    const std::vector<Asked> all = drawn(place.small()  ? 64
                                         : place.full() ? 1 << 20
                                                        : 1 << 16,
                                         static_cast<std::int64_t>(place.seed()));
    Outcome outcome;
    for (const bool sized : {false, true})
        add(outcome.tally, by_reference(all, sized), on_device(place.session(Precision::single_), all, sized),
            sized ? "eight words of charges of many sizes" : "eight words of charges of size 1");
    conclude(outcome);
    return outcome;
}

}  // namespace

std::vector<Check> term_checks() { return {{"aggregates/terms", "aggregates", true, check_terms}}; }

}  // namespace pelage::verify
