// Micro benchmarks: sorting points into bins and finding their neighbours, beside nanoflann.
#include "bench/points.hpp"
#include "micro.hpp"

namespace {

using namespace pelage;

void search(benchmark::State& state, bench::Task& task) {
    task.work(1);
    for (auto _ : state) task.work(1);
    micro::count_items(state, static_cast<double>(state.range(0)));
}

void query_bins(benchmark::State& state, bool shuffled) {
    search(state, *bench::opencl_search(micro::session(),
                                        bench::make_points(static_cast<std::size_t>(state.range(0)), shuffled)));
}

void query_nanoflann(benchmark::State& state, bool shuffled) {
    search(state,
           *bench::nanoflann_search(bench::make_points(static_cast<std::size_t>(state.range(0)), shuffled), false));
}

}  // namespace

BENCHMARK_CAPTURE(query_bins, hexagonal, false)
    ->Arg(20'000)
    ->Arg(200'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(query_bins, scattered, true)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(query_nanoflann, hexagonal, false)
    ->Arg(20'000)
    ->Arg(200'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
