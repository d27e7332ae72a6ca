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

Crew crew(Machine& machine, const SweepOptions& options, double cells, std::size_t tiles, const cluster::Ranks* ranks) {
    constexpr double small = 1 << 17;
    const bool processor = !machine.opencl || machine.info.processor();
    const std::size_t here = ranks == nullptr ? 1 : static_cast<std::size_t>(ranks->count_here());
    // Several small lattices share a card: one alone leaves most of it idle.
    const std::size_t of_small = processor ? std::thread::hardware_concurrency() / here : 8;
    const bool alone = cells > small && (here == 1 || !processor);
    const std::size_t wanted = options.jobs != 0 ? options.jobs : alone ? 1 : of_small;
    const std::size_t jobs = std::clamp<std::size_t>(wanted, 1, tiles);
    return {machine, options.run.precision, jobs, jobs == 1 && (here == 1 || !processor)};
}

Workers::Workers(const std::vector<Crew>& crews, sweep::Share& share, const TileRunner& runner) {
    std::vector<Backend*> all;
    try {
        for (const Crew& crew : crews) {
            if (crew.whole_machine) all.push_back(crew.machine.backend.get());
            for (std::size_t i = 0; i < crew.jobs && !crew.whole_machine; ++i) {
                backends_.push_back(backend_of_one(crew.machine, crew.precision));
                all.push_back(backends_.back().get());
            }
        }
    } catch (...) {
        share.end(std::current_exception());
    }
    for (Backend* const backend : all)
        threads_.emplace_back([&share, &runner, backend] { work(*backend, share, runner); });
}

}  // namespace pelage::app
