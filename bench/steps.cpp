// Micro benchmarks: one iteration of each lattice case, by single steps and fused, and of free cells.
#include "bench/cases.hpp"
#include "bench/tissue_tasks.hpp"
#include "core/prepattern.hpp"
#include "micro.hpp"

#include <algorithm>
#include <string>

namespace {

using namespace pelage;

const bench::Case& case_of(const std::string& name) {
    const auto& cases = bench::all_cases();
    return *std::ranges::find_if(cases, [&](const bench::Case& one) { return one.name == name; });
}

void advance(benchmark::State& state, const std::string& name, Path path, std::uint64_t stretch) {
    const bench::Case& one = case_of(name);
    const Experiment experiment = bench::experiment_of(one, static_cast<std::size_t>(state.range(0)));
    const auto initial = std::make_shared<const Snapshot>(initial_state(experiment));
    const auto task = bench::opencl_task(micro::session(path), experiment, initial);
    task->work(stretch);  // compiles
    for (auto _ : state) task->work(stretch);
    micro::count_items(state, static_cast<double>(initial->cells() * stretch));
}

void lattice_step(benchmark::State& state, const std::string& name) { advance(state, name, Path::step, 16); }
void lattice_streamed(benchmark::State& state, const std::string& name) { advance(state, name, Path::streamed, 256); }
void free_cells(benchmark::State& state) { advance(state, "tissue", Path::automatic, 32); }

}  // namespace

#define PELAGE_LATTICE(NAME)                                                                                         \
    BENCHMARK_CAPTURE(lattice_step, NAME, #NAME)->Arg(128)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime(); \
    BENCHMARK_CAPTURE(lattice_streamed, NAME, #NAME)->Arg(128)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime()
PELAGE_LATTICE(turing);
PELAGE_LATTICE(reinforcement);
PELAGE_LATTICE(anisotropic);
PELAGE_LATTICE(noise);
BENCHMARK(free_cells)->Arg(6'000)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();
