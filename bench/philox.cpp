// Micro benchmarks: random numbers by counter, on the host and on the device.
#include "core/philox.hpp"
#include "micro.hpp"
#include "opencl/device/program.hpp"

#include <string>

namespace {

using namespace pelage;

constexpr const char* draws_kernel = R"(
__kernel void draws(__global uint* restrict sums, int count) {
    const uintv cell = (uintv)get_global_id(0) * PELAGE_WIDTH + LANES;
    uintv sum = 0;
    for (int i = 0; i < count; ++i) {
        const struct pelage_words words = DRAW(cell, (uint)i, 0u, 0u, 1u, 0u);
        sum ^= words.x ^ words.y ^ words.z ^ words.w;
    }
    STORE(sum, sums + get_global_id(0) * PELAGE_WIDTH);
}
)";

void philox_host(benchmark::State& state) {
    std::uint32_t iteration = 0;
    for (auto _ : state) benchmark::DoNotOptimize(philox4x32_10({7, ++iteration, 0, 0}, {1, 0}));
    micro::count_items(state, 1);
}

// Draws of four words, eight vectors of lanes deep in registers.
void philox_device(benchmark::State& state) {
    const auto session = micro::session();
    const int width = static_cast<int>(state.range(0));
    Source source;
    source.text("#define PELAGE_WIDTH " + std::to_string(width) + "\n")
        .file("common/prelude.cl")
        .file("rules/philox.cl");
    cl::Kernel kernel(session->build(source.text(draws_kernel).str()), "draws");
    constexpr std::size_t items = 4096;
    constexpr cl_int count = 64;
    const cl::Buffer sums = micro::filled(*session, std::vector<cl_uint>(items * static_cast<std::size_t>(width)));
    kernel.setArg(0, sums);
    kernel.setArg(1, count);
    const auto launch = [&] {
        session->queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items), cl::NDRange(64));
        session->queue().finish();
    };
    launch();  // compiles
    for (auto _ : state) launch();
    micro::count_items(state, static_cast<double>(items) * width * count);
}

}  // namespace

BENCHMARK(philox_host);
BENCHMARK(philox_device)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond)->UseRealTime();
