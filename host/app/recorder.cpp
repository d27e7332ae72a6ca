// See recorder.hpp.
#include "app/recorder.hpp"

#include "core/forecast.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint.hpp"
#include "io/picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pelage::app {

namespace {

constexpr std::size_t worth_telling = 1'000'000;  // cells

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

// One for all pictures of a run: those of a growing tissue are in one scale then.
std::size_t enlargement_of(const Experiment& experiment, std::uint64_t last) {
    const auto size = final_size(experiment, last);
    if (!size) return 0;
    return enlargement(static_cast<std::size_t>(size->columns), static_cast<std::size_t>(size->rows));
}

void add_search(Manifest& manifest, const Tally& tally, const std::string& neighbours) {
    if (tally.search.iterations == 0) return;
    manifest.more_texts["neighbours"] = neighbours;
    manifest.more_numbers["neighbour_miss_rate"] = tally.search.miss_rate();
    if (tally.growing.iterations > 0) manifest.more_numbers["neighbour_miss_rate_growing"] = tally.growing.miss_rate();
    manifest.more_counts["neighbours_missed"] = tally.search.neighbours_missed;
    manifest.more_counts["neighbours_exact"] = tally.search.neighbours_exact;
}

}  // namespace

Recorder::Recorder(const RunOptions& options, const Experiment& experiment, const Machine& machine,
                   std::optional<std::uint64_t> resumed_at, std::uint64_t last,
                   std::function<void(const std::string&, bool)> tell)
    : options_(options),
      experiment_(experiment),
      machine_(machine),
      folder_(options.folder()),
      tell_(std::move(tell)),
      identity_(run_identity(experiment.text, experiment.run_seed(), options.precision)),
      ledger_(folder_, identity_, resumed_at),
      reel_(folder_, experiment, identity_, resumed_at),
      warning_(lost_colours()) {
    result_options_.precision = options.precision;
    if (options.cells == "hexagon") result_options_.drawing.shape = CellShape::hexagon;
    if (options.cells == "voronoi") result_options_.drawing.shape = CellShape::voronoi;
    result_options_.drawing.polarity_marks = options.polarity_marks;
    result_options_.exr_type = options.exr_type == "half" ? ExrType::half : ExrType::float_;
    result_options_.deep_png = options.png_bits == "16";
    result_options_.attributes = attributes_of(options, experiment, machine);
    result_options_.enlargement = enlargement_of(experiment, last);
    result_options_.before = [this](const std::vector<std::string>& files) { ledger_.begin(files); };
}

// The ledger has only kept files by now.
std::string Recorder::lost_colours() const {
    for (const std::string& file : ledger_.files()) {
        const auto iteration = iteration_of(file);
        if (!iteration || !file.ends_with(".png") || reel_.can_redraw(*iteration)) continue;
        return fmt::format(
            "{} is missing or damaged: the pictures from before the checkpoint, such as {}, keep a range of "
            "colours that those to come do not share",
            (folder_ / reel_name).string(), file);
    }
    return {};
}

void Recorder::write(const Snapshot& state, const std::string& stem, const SharedRanges& ranges,
                     const std::vector<Format>& formats) {
    const auto start = std::chrono::steady_clock::now();
    result_options_.ranges = ranges;
    result_options_.formats = formats;
    result_options_.begins = [this, large = state.cells() >= worth_telling](const std::string& file) {
        tell_(file, large);
    };
    write_results(folder_, stem, state, experiment_, result_options_);
    ledger_.written();
    writing_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Recorder::snapshot(const Snapshot& state) {
    const auto formats = options_.format_list();
    const bool pictures = std::find(formats.begin(), formats.end(), Format::png) != formats.end();
    write(state, std::to_string(state.iteration), pictures ? reel_.keep(state) : SharedRanges{}, formats);
}

void Recorder::results(const Snapshot& state) { write(state, "final", {}, options_.format_list()); }

namespace {

// Those of the formats wanted that show colours.
std::vector<Format> redrawn(const std::vector<Format>& wanted) {
    std::vector<Format> formats{Format::png};
    if (std::ranges::find(wanted, Format::ply) != wanted.end()) formats.push_back(Format::ply);
    return formats;
}

}  // namespace

void Recorder::settle() {
    result_options_.ranged_only = true;  // the reel knows no more
    reel_.redraw([this](const Snapshot& state, const SharedRanges& ranges, const OutputValues& values) {
        result_options_.values = values;
        write(state, std::to_string(state.iteration), ranges, redrawn(options_.format_list()));
    });
    result_options_.ranged_only = false;
    result_options_.values.clear();
    reel_.discard();
}

std::filesystem::path Recorder::checkpoint(const Snapshot& state) { return save(state, "checkpoint.pelage"); }

std::filesystem::path Recorder::dump(const Snapshot& state) {
    ledger_.begin({"non-finite.pelage"});
    const auto path = save(state, "non-finite.pelage");
    ledger_.written();
    return path;
}

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

Manifest Recorder::facts() const {
    Manifest manifest;
    manifest.backend = machine_.kind;
    manifest.device = machine_.device;
    manifest.driver = machine_.driver;
    manifest.platform = machine_.platform;
    manifest.precision = options_.precision;
    manifest.seed = experiment_.run_seed();
    manifest.version = PELAGE_VERSION;
    manifest.build_options = machine_.build_options;
    manifest.fast = options_.fast;
    manifest.options = options_.given;
    manifest.started = started_;
    if (!machine_.tuning.empty()) manifest.more_texts["tuning"] = machine_.tuning;
    return manifest;
}

void Recorder::write_drawn() {
    const std::string name = "drawn.pex";
    ledger_.begin({name});
    AtomicFile file(folder_ / name);
    file.write(experiment_.text);
    file.commit();
}

void Recorder::manifest(const Snapshot& state, const Tally& tally, const char* end) {
    Manifest manifest = facts();
    manifest.iterations = state.iteration;
    manifest.time = experiment_.time_at(state.iteration);
    manifest.cells = state.cells();
    manifest.columns = state.columns;
    manifest.rows = state.rows;
    if (state.volume()) manifest.more_counts["layers"] = state.layers;
    manifest.seconds = tally.seconds;
    manifest.updates_per_second = tally.updates_per_second();
    if (options_.random) write_drawn();
    manifest.files = ledger_.files();
    manifest.more_texts["end"] = end;
    if (!tally.notes.empty()) manifest.more_texts["fusion"] = fmt::format("{}", fmt::join(tally.notes, "; "));
    manifest.more_counts["first_iteration"] = tally.started_at;
    manifest.more_numbers["writing_seconds"] = writing_;
    if (tally.frames > 0) {
        manifest.more_texts["film"] = options_.video.file.string();
        manifest.more_counts["film_frames"] = tally.frames;
        manifest.more_numbers["film_seconds"] = tally.film_seconds;
    }
    add_search(manifest, tally, options_.neighbours);
    ledger_.written();
    write_manifest(folder_ / "manifest.json", manifest, experiment_);
    ledger_.finish();
    if (!options_.json.empty()) write_manifest(options_.json, manifest, experiment_);
}

}  // namespace pelage::app
