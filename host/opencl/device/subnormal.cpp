// See subnormal.hpp.
#include "opencl/device/subnormal.hpp"

#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <bit>
#include <cstdint>

namespace pelage {

namespace {

constexpr std::array<cl_float, 7> numbers{0x1.8p-126f, -0x1p-126f, 0x1p-100f, 0x1p-40f, 0.0f, 0x1p-130f, 0x1p40f};

// In the order of kernels/common/subnormal.cl; each result is 0 where subnormal numbers are.
constexpr std::array<const char*, 8> kinds{
    "sums", "products", "fma", "quotients", "terms of a sum", "factors of products", "factors of fma", "comparisons"};

// The results where they are kept.
constexpr std::array<cl_float, kinds.size()> kept_results{0x1p-127f, 0x1p-140f, 0x1p-140f, 0x1p-140f,
                                                          0x1p-130f, 0x1p-90f,  0x1p-90f,  1.0f};

std::array<cl_float, kinds.size()> results(const Session& session) {
    Source source;
    source.file("common/subnormal.cl");
    cl::Kernel kernel(session.build(source.str()), "pelage_subnormal");
    const cl::Buffer in = session.buffer(sizeof numbers, "numbers near 0");
    const cl::Buffer out = session.buffer(sizeof(cl_float) * kinds.size(), "results near 0");
    session.queue().enqueueWriteBuffer(in, CL_TRUE, 0, sizeof numbers, numbers.data());
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    session.launch(kernel, cl::NDRange(1), cl::NDRange(1));
    std::array<cl_float, kinds.size()> found{};
    session.queue().enqueueReadBuffer(out, CL_TRUE, 0, sizeof found, found.data());
    return found;
}

}  // namespace

std::vector<std::string> keeps_subnormals(const Session& session) {
    const auto found = with_device(session.info().name, [&] { return results(session); });
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (found[i] != 0.0f) kept.emplace_back(kinds[i]);
    }
    return kept;
}

std::string subnormal_fault(const Session& session) {
    const auto found = with_device(session.info().name, [&] { return results(session); });
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (found[i] == 0.0f || std::bit_cast<std::uint32_t>(found[i]) == std::bit_cast<std::uint32_t>(kept_results[i]))
            continue;
        return fmt::format("{} of subnormal numbers gave {:a}, which is neither 0 nor {:a}", kinds[i], found[i],
                           kept_results[i]);
    }
    return {};
}

std::string subnormal_difference(const Session& session) {
    if (session.is_double()) return {};
    const std::vector<std::string> kept = keeps_subnormals(session);
    const bool flushes = processor_flushes();
    if (flushes ? kept.empty() : kept.size() == kinds.size()) return {};
    const std::string how =
        kept.empty()
            ? fmt::format("device '{}' takes subnormal numbers for 0, this processor does not", session.info().name)
            : fmt::format("device '{}' keeps subnormal numbers ({})", session.info().name, fmt::join(kept, ", "));
    return how + "; its results are the reference's as long as no number but 0 is nearer to 0 than 2^-126";
}

}  // namespace pelage
