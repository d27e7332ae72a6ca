// See tile_runner.hpp.
#include "app/tile_runner.hpp"

#include "app/interrupt.hpp"
#include "app/read_experiment.hpp"
#include "app/settings.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/seed.hpp"
#include "core/stability.hpp"
#include "io/npy.hpp"
#include "sweep/tile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

namespace pelage::app {

TileRunner::TileRunner(const SweepOptions& options, const SweepDesign& design, const std::string& text,
                       const sweep::Table& table)
    : options_(options),
      design_(design),
      text_(text),
      table_(table),
      steady_(steady_tolerance(options)),
      folder_(options.run.folder() / "tiles") {}

Experiment TileRunner::experiment(std::size_t tile) const {
    const sweep::Point& point = design_.points[tile];
    std::vector<Setting> settings = settings_of(options_.run.settings);
    settings.insert(settings.end(), point.settings.begin(), point.settings.end());
    Experiment experiment = read(settings, point);
    if (options_.run.seed == 0)
        throw Error("--seed 0 takes one from the clock, another each time; a sweep needs one that can be repeated");
    if (options_.run.seed) experiment.seed = options_.run.seed;
    if (seeded_by_clock(experiment))
        throw Error(
            fmt::format("{}: the seed comes from the clock; give one with --seed, so that tiles can be "
                        "repeated",
                        experiment.source));
    if (point.replicate > 0) experiment.seed = experiment.run_seed() + static_cast<std::int64_t>(point.replicate);
    sweep::check_measurable(experiment);
    return experiment;
}

// The experiment's reader knows of --set alone.
Experiment TileRunner::read(const std::vector<Setting>& settings, const sweep::Point& point) const {
    try {
        return experiment_of(text_, options_.run.file, StartPictures::read, settings);
    } catch (const Error& error) {
        const std::string_view message = error.what();
        for (const Setting& one : point.settings) {
            const std::string start = fmt::format("--set {}=", one.name);
            if (message.starts_with(start))
                throw Error(fmt::format("{}={}", blamed(options_, one.name), message.substr(start.size())));
        }
        throw;
    }
}

std::uint64_t TileRunner::last_iteration(const Experiment& experiment) const {
    return options_.run.iterations.value_or(experiment.last_iteration());
}

std::string TileRunner::name_of(std::size_t tile) const {
    std::string where;
    for (const Setting& one : design_.points[tile].settings) where += fmt::format(" {}={}", one.name, one.value);
    return fmt::format("tile {}{}", tile, where.empty() ? "" : fmt::format(" ({})", where.substr(1)));
}

std::optional<std::string> TileRunner::run(Backend& backend, std::size_t tile) const {
    return run(backend, ready(tile));
}

template <class Work>
std::invoke_result_t<Work> TileRunner::named(std::size_t tile, Work work) const {
    try {
        return work();
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", name_of(tile), error.what()));
    }
}

Experiment TileRunner::named_experiment(std::size_t tile) const {
    return named(tile, [&] { return experiment(tile); });
}

TileRunner::Ready TileRunner::ready(std::size_t tile) const {
    return named(tile, [&] {
        Ready ready;
        ready.tile = tile;
        ready.experiment = std::make_shared<const Experiment>(experiment(tile));
        ready.initial = initial_state(*ready.experiment, options_.run.precision);
        ready.unstable = !options_.run.force && find_instability(*ready.experiment, ready.initial).has_value();
        return ready;
    });
}

sweep::TileOptions TileRunner::course(const Ready& ready) const {
    return {last_iteration(*ready.experiment), steady_, Interrupt::came};
}

std::optional<std::string> TileRunner::run(Backend& backend, const Ready& ready) const {
    const auto start = std::chrono::steady_clock::now();
    return named(ready.tile, [&]() -> std::optional<std::string> {
        std::optional<sweep::TileResult> result;
        if (!ready.unstable) {
            const auto tissue = backend.make_tissue(*ready.experiment, ready.initial);
            result = sweep::run_tile(*tissue, *ready.experiment, course(ready));
            if (!result) return std::nullopt;
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return row(ready, std::move(result).value_or(sweep::TileResult{}), seconds);
    });
}

std::string TileRunner::row(const Ready& ready, sweep::TileResult result, double seconds) const {
    if (ready.unstable)
        result.verdict = stats::Verdict::unstable;
    else
        keep(*ready.experiment, ready.tile, result.state);
    result.of = sweep::measured(*ready.experiment);
    return table_.row(ready.tile, design_.points[ready.tile], ready.experiment->run_seed(), result, seconds);
}

bool TileRunner::has_files(std::size_t tile) const {
    if (!values_there(tile)) return false;
    if (options_.run.formats.empty()) return true;
    const std::vector<Format> wanted = options_.run.format_list();
    return std::ranges::all_of(format_table(), [&](const FormatRow& row) {
        return row.format == Format::npy || row.lattice.ending == nullptr ||
               std::ranges::find(wanted, row.format) == wanted.end() ||
               std::filesystem::exists(folder_ / (std::to_string(tile) + row.lattice.ending));
    });
}

std::optional<NpyArray> TileRunner::values_there(std::size_t tile) const {
    if (!std::filesystem::exists(values_of(tile))) return std::nullopt;
    try {
        NpyArray array = read_npy(values_of(tile));
        const bool planes = array.shape.size() == 3 && array.shape[0] == 3;  // of `rgb`
        if (array.shape.size() == 2 || planes) return array;
    } catch (const Error&) {
        return std::nullopt;  // damaged: as if it were not there
    }
    return std::nullopt;
}

std::filesystem::path TileRunner::values_of(std::size_t tile) const { return folder_ / fmt::format(".{}.npy", tile); }

void TileRunner::keep(const Experiment& experiment, std::size_t tile, const Snapshot& state) const {
    const std::vector<double> shown = sweep::shown(experiment, state);
    std::vector<std::size_t> shape{state.rows, state.columns};
    if (shown.size() > state.cells()) shape.insert(shape.begin(), shown.size() / state.cells());
    write_npy(values_of(tile), shape, shown, NpyType::float32);
    if (options_.run.formats.empty()) return;
    ResultOptions what;
    what.formats = options_.run.format_list();
    what.precision = options_.run.precision;
    what.attributes["experiment"] = experiment.text;
    what.attributes["seed"] = std::to_string(experiment.run_seed());
    write_results(folder_, std::to_string(tile), state, experiment, what);
}

}  // namespace pelage::app
