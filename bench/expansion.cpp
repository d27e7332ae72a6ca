// Micro benchmarks: inserting one column and one row into a matrix that lies on the device.
#include "bench/cases.hpp"
#include "core/growth.hpp"
#include "core/prepattern.hpp"
#include "micro.hpp"
#include "opencl/lattice/tissue.hpp"

#include <algorithm>

namespace {

using namespace pelage;

void insert(benchmark::State& state, bool column) {
    const auto side = static_cast<std::size_t>(state.range(0));
    const auto& cases = bench::all_cases();
    const auto one = std::ranges::find_if(cases, [](const bench::Case& c) { return c.name == "three-chemicals"; });
    const auto experiment = std::make_shared<const Experiment>(bench::experiment_of(*one, side));
    const auto session = micro::session(Path::step);
    const auto tissue = make_opencl_lattice(session, experiment, initial_state(*experiment));
    std::uint64_t iteration = 0;
    double cells = 0;
    for (auto _ : state) {
        state.PauseTiming();
        Expand expand;
        (column ? expand.columns : expand.rows) = 1;
        const Insertion insertion =
            draw_insertion(expand, column, tissue->columns(), tissue->rows(), 1, ++iteration, 0, 0);
        session->queue().finish();
        state.ResumeTiming();
        tissue->expand(insertion);
        session->queue().finish();
        cells += static_cast<double>(tissue->cells());
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(cells));
}

}  // namespace

BENCHMARK_CAPTURE(insert, column, true)
    ->Arg(130)
    ->Arg(1024)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime()
    ->Iterations(100);
BENCHMARK_CAPTURE(insert, row, false)
    ->Arg(130)
    ->Arg(1024)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime()
    ->Iterations(100);
