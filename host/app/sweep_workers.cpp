// See sweep_workers.hpp.
#include "app/sweep_workers.hpp"

#include "app/interrupt.hpp"
#include "app/memory.hpp"
#include "app/tile_batches.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "opencl/backend.hpp"
#include "opencl/device/device.hpp"
#include "reference/backend.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace pelage::app {

namespace {

std::unique_ptr<Backend> backend_of_one(const Crew& crew) {
    if (!crew.machine.opencl) return reference_backend(crew.precision);
    OpenclOptions wanted = *crew.machine.opencl;
    if (crew.batch == 1) wanted.units = 1;
    return opencl_backend(wanted);
}

RunOptions on_device(RunOptions options, std::size_t index) {
    options.device = std::to_string(index);
    return options;
}

// Of the usable devices those that `wanted` takes, by their index.
std::vector<std::size_t> devices_here(bool (*wanted)(const DeviceInfo&)) {
    std::vector<std::size_t> found;
    for (const DeviceInfo& device : list_devices()) {
        if (device.unusable.empty() && wanted(device)) found.push_back(device.index);
    }
    return found;
}

std::vector<std::size_t> cards_here() {
    return devices_here([](const DeviceInfo& device) { return device.type == "gpu" && !device.software_rasteriser(); });
}

std::vector<std::size_t> devices_worth_it() {
    const auto good = devices_here([](const DeviceInfo& device) { return !device.software_rasteriser(); });
    return good.empty() ? devices_here([](const DeviceInfo&) { return true; }) : good;
}

void work_in_batches(OpenclBackend& backend, std::size_t batch, sweep::Share& share, const TileRunner& runner) {
    try {
        const auto finished = [&](std::size_t tile, const std::string& row) { share.finished(tile, row); };
        for (;;) {
            std::vector<std::size_t> tiles;
            while (tiles.size() < batch) {
                const auto tile = share.next();
                if (!tile) break;
                tiles.push_back(*tile);
            }
            if (tiles.empty()) return;
            if (Interrupt::came() || !run_together(runner, backend, tiles, finished)) return share.end();
        }
    } catch (...) {
        share.end(std::current_exception());
    }
}

void work(Backend& backend, std::size_t batch, sweep::Share& share, const TileRunner& runner) {
    auto* const device = dynamic_cast<OpenclBackend*>(&backend);
    if (batch > 1 && device != nullptr) return work_in_batches(*device, batch, share, runner);
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

std::vector<Machine> sweep_machines(const RunOptions& options, const Experiment& experiment, const Footprint& needed,
                                    const cluster::Ranks* ranks) {
    std::vector<Machine> machines;
    if (options.device == "all") {
        for (const std::size_t index : devices_worth_it())
            machines.push_back(choose_machine(on_device(options, index), experiment, needed));
        if (!machines.empty()) return machines;
    }
    const char* variable = std::getenv("PELAGE_DEVICE");
    const bool chosen = !options.device.empty() || (variable != nullptr && *variable != '\0');
    const std::vector<std::size_t> cards =
        ranks == nullptr || chosen || options.backend == "reference" ? std::vector<std::size_t>{} : cards_here();
    const auto rank = static_cast<std::size_t>(ranks == nullptr ? 0 : ranks->rank_here());
    machines.push_back(
        choose_machine(cards.empty() ? options : on_device(options, cards[rank % cards.size()]), experiment, needed));
    return machines;
}

Crew crew(Machine& machine, const SweepOptions& options, const TileSize& size, const cluster::Ranks* ranks) {
    if (options.batch > 1 && !machine.opencl)
        throw Error("--batch " + std::to_string(options.batch) +
                    ": the reference runs each tile by itself; batches are for --backend opencl");
    const double cells = size.footprint.cells;
    constexpr double small = 1 << 17;
    const bool processor = !machine.opencl || machine.info.processor();
    const std::size_t here = ranks == nullptr ? 1 : static_cast<std::size_t>(ranks->count_here());
    // Several small lattices share a card: one alone leaves most of it idle.
    const std::size_t of_small = processor ? std::thread::hardware_concurrency() / here : 8;
    const bool alone = cells > small && (here == 1 || !processor);
    const std::size_t wanted = options.jobs != 0 ? options.jobs : alone ? 1 : of_small;
    const std::size_t jobs = std::clamp<std::size_t>(wanted, 1, size.tiles);
    const bool gains = !processor && cells <= small && !machine.info.software_rasteriser();
    const auto here_too = static_cast<double>(here);
    const std::size_t batch =
        options.batch != 0 ? options.batch
        : gains ? tiles_a_batch(size.footprint, size.last, size.tiles / here, jobs, usable_memory() / here_too)
                : 1;
    return {machine, options.run.precision, jobs, jobs == 1 && (here == 1 || !processor), batch};
}

Workers::Workers(const std::vector<Crew>& crews, sweep::Share& share, const TileRunner& runner) {
    std::vector<std::pair<Backend*, std::size_t>> all;  // and tiles a batch
    try {
        for (const Crew& crew : crews) {
            if (crew.whole_machine) all.emplace_back(crew.machine.backend.get(), crew.batch);
            for (std::size_t i = 0; i < crew.jobs && !crew.whole_machine; ++i) {
                backends_.push_back(backend_of_one(crew));
                all.emplace_back(backends_.back().get(), crew.batch);
            }
        }
    } catch (...) {
        share.end(std::current_exception());
    }
    for (const auto& one : all)
        threads_.emplace_back([&share, &runner, one] { work(*one.first, one.second, share, runner); });
}

}  // namespace pelage::app
