// See sweep_workers.hpp.
#include "app/sweep_workers.hpp"

#include "app/interrupt.hpp"
#include "opencl/backend.hpp"
#include "opencl/device/device.hpp"
#include "reference/backend.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string>

namespace pelage::app {

namespace {

std::unique_ptr<Backend> backend_of_one(const Machine& machine, Precision precision) {
    if (!machine.opencl) return reference_backend(precision);
    OpenclOptions wanted = *machine.opencl;
    wanted.units = 1;
    return opencl_backend(wanted);
}

void work(Backend& backend, sweep::Share& share, const TileRunner& runner) {
    try {
        for (auto tile = share.next(); tile; tile = share.next()) {
            const auto row = Interrupt::came() ? std::nullopt : runner.run(backend, *tile);
            if (!row) return share.end();
            share.finished(*tile, *row);
        }
    } catch (...) {
        share.end(std::current_exception());
    }
}

}  // namespace

RunOptions run_options_of_rank(const RunOptions& options, const cluster::Ranks* ranks) {
    const char* variable = std::getenv("PELAGE_DEVICE");
    const bool chosen = !options.device.empty() || (variable != nullptr && *variable != '\0');
    if (ranks == nullptr || chosen || options.backend == "reference") return options;
    std::vector<std::size_t> cards;
    for (const DeviceInfo& device : list_devices()) {
        if (device.type == "gpu" && device.unusable.empty() && !device.software_rasteriser())
            cards.push_back(device.index);
    }
    RunOptions own = options;
    if (!cards.empty()) own.device = std::to_string(cards[static_cast<std::size_t>(ranks->rank_here()) % cards.size()]);
    return own;
}

Crew crew(Machine& machine, const SweepOptions& options, double cells, std::size_t tiles, const cluster::Ranks* ranks) {
    constexpr double small = 1 << 17;
    const bool processor = !machine.opencl || machine.info.processor();
    const std::size_t here = ranks == nullptr ? 1 : static_cast<std::size_t>(ranks->count_here());
    const bool alone = here == 1 && (!processor || cells > small);
    std::size_t jobs = options.jobs;
    if (jobs == 0) jobs = !processor || alone ? 1 : std::thread::hardware_concurrency() / here;
    jobs = std::clamp<std::size_t>(jobs, 1, tiles);
    return {machine, options.run.precision, jobs, jobs == 1 && (here == 1 || !processor)};
}

Workers::Workers(const Crew& crew, sweep::Share& share, const TileRunner& runner) {
    if (crew.whole_machine) {
        threads_.emplace_back([&share, &runner, &backend = *crew.machine.backend] { work(backend, share, runner); });
        return;
    }
    try {
        for (std::size_t i = 0; i < crew.jobs; ++i) backends_.push_back(backend_of_one(crew.machine, crew.precision));
    } catch (...) {
        share.end(std::current_exception());
    }
    for (const auto& backend : backends_)
        threads_.emplace_back([&share, &runner, &one = *backend] { work(one, share, runner); });
}

}  // namespace pelage::app
