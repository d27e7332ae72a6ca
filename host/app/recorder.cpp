// See recorder.hpp.
#include "app/recorder.hpp"

#include "io/checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pelage::app {

namespace {

std::string name_of(Precision precision) { return precision == Precision::double_ ? "double" : "float"; }

Attributes attributes_of(const RunOptions& options, const Experiment& experiment, const Machine& machine) {
    return {{"experiment", experiment.text},
            {"seed", std::to_string(experiment.run_seed())},
            {"backend", machine.kind},
            {"device", machine.device},
            {"driver", machine.driver},
            {"build_options", machine.build_options},
            {"precision", name_of(options.precision)},
            {"version", PELAGE_VERSION}};
}

}  // namespace

Recorder::Recorder(const RunOptions& options, const Experiment& experiment, const Machine& machine)
    : options_(options), experiment_(experiment), machine_(machine), folder_(options.folder()) {
    result_options_.formats = parse_formats(options.formats);
    result_options_.precision = options.precision;
    if (options.cells == "hexagon") result_options_.drawing.shape = CellShape::hexagon;
    if (options.cells == "voronoi") result_options_.drawing.shape = CellShape::voronoi;
    result_options_.drawing.polarity_marks = options.polarity_marks;
    result_options_.attributes = attributes_of(options, experiment, machine);
}

void Recorder::write(const Snapshot& state, const std::string& stem) {
    const auto start = std::chrono::steady_clock::now();
    for (std::string& file : write_results(folder_, stem, state, experiment_, result_options_)) {
        if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(std::move(file));
    }
    writing_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Recorder::snapshot(const Snapshot& state) { write(state, std::to_string(state.iteration)); }

void Recorder::results(const Snapshot& state) { write(state, "final"); }

std::filesystem::path Recorder::checkpoint(const Snapshot& state) { return save(state, "checkpoint.pelage"); }

std::filesystem::path Recorder::dump(const Snapshot& state) { return save(state, "non-finite.pelage"); }

std::filesystem::path Recorder::save(const Snapshot& state, const char* name) const {
    CheckpointInfo info;
    info.experiment = experiment_.text;
    info.source = experiment_.source;
    info.folder = std::filesystem::absolute(options_.file).parent_path().string();
    info.precision = options_.precision;
    info.seed = experiment_.run_seed();
    info.backend = machine_.kind;
    info.device = machine_.device;
    info.version = PELAGE_VERSION;
    write_checkpoint(folder_ / name, state, info);
    return folder_ / name;
}

void Recorder::manifest(const Snapshot& state, const Tally& tally, const char* end) {
    Manifest manifest;
    manifest.backend = machine_.kind;
    manifest.device = machine_.device;
    manifest.driver = machine_.driver;
    manifest.platform = machine_.platform;
    manifest.precision = options_.precision;
    manifest.seed = experiment_.run_seed();
    manifest.iterations = state.iteration;
    manifest.cells = state.cells();
    manifest.columns = state.columns;
    manifest.rows = state.rows;
    manifest.seconds = tally.seconds;
    manifest.updates_per_second = tally.updates_per_second();
    manifest.version = PELAGE_VERSION;
    manifest.build_options = machine_.build_options;
    manifest.fast = options_.fast;
    manifest.files = files_;
    manifest.started = started_;
    manifest.more_texts["end"] = end;
    if (!tally.notes.empty()) manifest.more_texts["fusion"] = fmt::format("{}", fmt::join(tally.notes, "; "));
    if (!machine_.tuning.empty()) manifest.more_texts["tuning"] = machine_.tuning;
    manifest.more_numbers["first_iteration"] = static_cast<double>(tally.started_at);
    manifest.more_numbers["writing_seconds"] = writing_;
    if (tally.search.iterations > 0) {
        manifest.more_texts["neighbours"] = options_.neighbours;
        manifest.more_numbers["neighbour_miss_rate"] = tally.search.miss_rate();
        if (tally.growing.iterations > 0) {
            manifest.more_numbers["neighbour_miss_rate_growing"] = tally.growing.miss_rate();
        }
        manifest.more_numbers["neighbours_missed"] = static_cast<double>(tally.search.neighbours_missed);
        manifest.more_numbers["neighbours_exact"] = static_cast<double>(tally.search.neighbours_exact);
    }
    write_manifest(folder_ / "manifest.json", manifest, experiment_);
    if (!options_.json.empty()) write_manifest(options_.json, manifest, experiment_);
}

}  // namespace pelage::app
