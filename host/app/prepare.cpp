// See prepare.hpp.
#include "app/prepare.hpp"

#include "app/ledger.hpp"
#include "app/random_settings.hpp"
#include "app/read_experiment.hpp"
#include "app/settings.hpp"
#include "core/error.hpp"
#include "core/seed.hpp"
#include "core/space.hpp"
#include "core/stability.hpp"
#include "io/checkpoint.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;

void compare(const Checkpoint& checkpoint, const Experiment& experiment, const RunOptions& options,
             std::uint64_t last) {
    const std::string name = options.resume.string();
    if (checkpoint.info.experiment != experiment.text) {
        throw Error(
            fmt::format("{} was saved by another experiment ({}) than {}, or that was edited or --set otherwise since",
                        name, checkpoint.info.source, experiment.source));
    }
    if (checkpoint.info.precision != options.precision) {
        const bool is_double = checkpoint.info.precision == Precision::double_;
        throw Error(fmt::format("{} was saved with --precision {}; resume it with the same", name,
                                is_double ? "double" : "float"));
    }
    if (checkpoint.info.seed != experiment.run_seed()) {
        throw Error(fmt::format("{} was saved with seed {}, this run has {}; resume it with --seed {}", name,
                                checkpoint.info.seed, experiment.run_seed(), checkpoint.info.seed));
    }
    if (checkpoint.snapshot.iteration > last) {
        throw Error(fmt::format("{} is at iteration {}, past the end of this run at {}; --iterations can move the end",
                                name, checkpoint.snapshot.iteration, last));
    }
}

// The state that is resumed came from the files as they were when the run began.
void recall_inputs(Experiment& experiment, const RunOptions& options) {
    const auto identity = run_identity(experiment.text, experiment.run_seed(), options.precision);
    const auto earlier = earlier_inputs(options.resume, identity);
    for (InputFile& input : experiment.inputs) {
        const auto found =
            std::find_if(earlier.begin(), earlier.end(), [&](const InputFile& one) { return one.name == input.name; });
        if (found == earlier.end()) continue;
        if (input.throughout && !found->sha256.empty() && input.sha256 != found->sha256)
            throw Error(fmt::format("{}: '{}' is not the file that the run began with: its SHA-256 was {} and is {}",
                                    experiment.source, input.name, found->sha256, input.sha256));
        input.sha256 = found->sha256;
    }
}

// Drawn ones first, so that --set prevails.
std::vector<Setting> all_settings(const RunOptions& options) {
    std::vector<Setting> settings = settings_of(options.settings);
    if (!options.random) return settings;
    if (options.file == standard_input) throw Error("--random reads the experiment twice; give a file, not '-'");
    const Experiment plain = read_experiment(options.file, nullptr, StartPictures::left_out, settings);
    std::vector<Setting> all = random_settings(plain, *options.random);
    all.insert(all.end(), settings.begin(), settings.end());
    return all;
}

}  // namespace

Prepared prepare(const RunOptions& options) {
    Prepared prepared;
    std::optional<Checkpoint> checkpoint;
    if (!options.resume.empty()) checkpoint = read_checkpoint(options.resume);
    Experiment& experiment = prepared.experiment;
    Outline outline;
    experiment = read_experiment(options.file, &outline, checkpoint ? StartPictures::left_out : StartPictures::read,
                                 all_settings(options));
    if (options.seed) experiment.seed = options.seed;
    settle_seed(experiment, checkpoint ? checkpoint->info.seed : seed_from_clock());
    prepared.last = options.iterations.value_or(experiment.last_iteration());
    // A run made shorter by --iterations is no mistake of the file's.
    prepared.warnings = lint(experiment, outline, std::max(prepared.last, experiment.last_iteration()));
    if (checkpoint) {
        compare(*checkpoint, experiment, options, prepared.last);
        recall_inputs(experiment, options);
        prepared.resumed_at = checkpoint->snapshot.iteration;
        prepared.resumed = std::move(checkpoint->snapshot);
    }
    return prepared;
}

namespace {

void check_mesh_formats(const RunOptions& options, const Experiment& experiment) {
    if (options.formats.empty()) return;
    const auto formats = options.format_list();
    const bool mesh = std::holds_alternative<MeshCells>(space_of(experiment));
    const auto wanted = [&](Format format) { return std::ranges::find(formats, format) != formats.end(); };
    if (mesh && wanted(Format::exr))
        throw Error(experiment.source + ": a mesh makes no EXR picture; leave exr out of --format");
    if (!mesh && wanted(Format::ply))
        throw Error(experiment.source + ": only a mesh makes a .ply file; leave ply out of --format");
}

}  // namespace

void check_formats(const RunOptions& options, const Experiment& experiment) {
    check_mesh_formats(options, experiment);
    if (options.formats.empty() || experiment.texture || keeps_places(space_of(experiment))) return;
    const auto formats = options.format_list();
    if (std::find(formats.begin(), formats.end(), Format::exr) == formats.end()) return;
    throw Error(
        fmt::format("{}: free cells make no EXR picture by themselves; add 'texture size WIDTH HEIGHT' to the "
                    "experiment, or leave exr out of --format",
                    experiment.source));
}

void check_stability(const Experiment& experiment, const Snapshot& initial) {
    const std::optional<Instability> found = find_instability(experiment, initial);
    if (!found) return;
    const std::string where = found->phase.empty() ? "" : fmt::format(" in phase '{}'", found->phase);
    throw Error(fmt::format(
        "{}: chemical '{}' diffuses unstably{}: with {} the time step may be {:.6g} at most, it "
        "is {}; lower `define time_step` or the rate, or go on with --force",
        experiment.source, found->chemical, where, found->rates(), found->largest_time_step, found->time_step));
}

void prepare_folder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) throw Error(fmt::format("folder {} cannot be made: {}", folder.string(), failure.message()));
    if (!fs::is_directory(folder)) throw Error(fmt::format("{} is not a folder", folder.string()));
    const fs::path probe = folder / fmt::format(".probe-{}", getpid());
    errno = 0;
    const bool writable = std::ofstream(probe).put('\n').flush().good();
    const int reason = errno;
    fs::remove(probe, failure);
    if (!writable)
        throw Error(fmt::format("folder {} cannot be written to: {}", folder.string(), system_reason(reason)));
}

void try_folder(const fs::path& folder) {
    std::vector<fs::path> made;
    for (fs::path at = fs::absolute(folder).lexically_normal(); !fs::exists(at); at = at.parent_path())
        made.push_back(at);
    prepare_folder(folder);
    std::error_code ignored;
    for (const fs::path& at : made) fs::remove(at, ignored);
}

void prepare_json(const fs::path& file) {
    if (file.empty() || (fs::exists(file) && fs::is_other(file))) return;  // a device or pipe needs no folder
    if (fs::is_directory(file)) throw Error(fmt::format("--json {} is a folder; name a file", file.string()));
    prepare_folder(fs::absolute(file).parent_path());
}

}  // namespace pelage::app
