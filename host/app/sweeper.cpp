// See sweeper.hpp.
#include "app/sweeper.hpp"

#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/machine.hpp"
#include "app/memory.hpp"
#include "app/prepare.hpp"
#include "app/progress.hpp"
#include "app/read_experiment.hpp"
#include "app/say.hpp"
#include "app/self_check.hpp"
#include "app/settings.hpp"
#include "app/sweep_sheet.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/seed.hpp"
#include "core/stability.hpp"
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"
#include "io/locked.hpp"
#include "io/npy.hpp"
#include "io/sha256.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "sweep/table.hpp"
#include "sweep/tile.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Design {
    std::vector<sweep::Axis> axes;  // of a grid
    std::vector<sweep::Point> points;
    std::vector<std::string> names;
};

Design design_of(const SweepOptions& options) {
    Design design;
    if (!options.points.empty()) {
        if (!options.vary.empty()) throw Error("--points gives all values; leave --vary out, or --points");
        design.points = sweep::read_points(options.points);
    } else if (options.samples > 0) {
        std::vector<sweep::Range> ranges;
        for (const std::string& word : options.vary) ranges.push_back(sweep::parse_range(word));
        if (ranges.empty()) throw Error("--samples draws within the ranges of --vary; give at least one");
        design.points = sweep::samples(ranges, options.samples, options.latin,
                                       static_cast<std::uint64_t>(options.run.seed.value_or(1)));
    } else {
        if (options.latin) throw Error("--latin says how samples are drawn; give their number with --samples");
        for (const std::string& word : options.vary) design.axes.push_back(sweep::parse_axis(word));
        if (design.axes.empty() && options.replicates == 1)
            throw Error("nothing varies; give --vary NAME=LOW:HIGH:COUNT, --points FILE or --replicates N");
        design.points = sweep::grid(design.axes, options.replicates);
    }
    for (const Setting& one : design.points.front().settings) design.names.push_back(one.name);
    return design;
}

// Samples of parameters that some statement takes for whole numbers become whole.
Design whole_where_needed(Design design, const SweepOptions& options) {
    if (options.samples == 0) return design;
    const Experiment plain =
        read_experiment(options.run.file, nullptr, StartPictures::left_out, settings_of(options.run.settings));
    for (sweep::Point& point : design.points) {
        for (Setting& one : point.settings) {
            const auto parameter = std::ranges::find(plain.parameters, one.name, &Parameter::name);
            if (parameter != plain.parameters.end() && parameter->whole)
                one.value = fmt::format("{:.0f}", std::round(std::stod(one.value)));
        }
    }
    return design;
}

std::optional<double> tolerance_of(const SweepOptions& options) {
    if (options.until.empty()) return std::nullopt;
    double value = 0.0;
    const std::string& text = options.until.back();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc{} && end == text.data() + text.size() && value > 0.0 && value < 1.0;
    if (options.until.size() != 2 || options.until.front() != "steady" || !number)
        throw Error("--until is written --until steady TOLERANCE, with a tolerance between 0 and 1, as in 1e-4");
    return value;
}

// A line that the next one replaces on a terminal.
class Bar {
public:
    explicit Bar(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}
    ~Bar() { clear(); }
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;

    void show(std::size_t done, std::size_t all, double seconds_a_tile) const {
        if (!shown_) return;
        say(stderr, "\r\x1b[Ktile {} of {}, {} left", grouped(done), grouped(all),
            clock_time(seconds_a_tile * static_cast<double>(all - done)));
    }
    void clear() const {
        if (shown_) say(stderr, "\r\x1b[K");
    }

private:
    bool shown_;
};

class Sweep {
public:
    explicit Sweep(const SweepOptions& options)
        : options_(options),
          design_(whole_where_needed(design_of(options), options)),
          steady_(tolerance_of(options)),
          folder_(options.run.folder()),
          first_(experiment_of(0)),
          table_(folder_ / "sweep.csv", design_.names) {
        sweep::check_measurable(first_);
        check_ranges();
        last_ = options_.run.iterations.value_or(first_.last_iteration());
    }

    int carry_out() {
        Machine machine = choose();
        if (!trusted(machine)) return failed_check;
        prepare_folder(folder_ / "tiles");
        const FolderLock lock(folder_);
        claim();
        table_.take_up(design_.points);
        announce(machine);
        const Interrupt interrupt;
        const Clock::time_point start = Clock::now();
        if (!run_tiles(machine, start)) return stopped();
        return finish(run_, seconds_since(start));
    }

private:
    static double seconds_since(Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    // Tiles at one time. Small ones on processors run side by side, each on one of them: strips that wait for each
    // other would cost more.
    std::size_t jobs(const Machine& machine) const {
        constexpr double small = 1 << 17;  // cells
        if (options_.jobs != 0) return std::min(options_.jobs, design_.points.size());
        const bool processor = !machine.opencl || machine.info.processor();
        if (!processor || footprint(first_, last_, options_.run.precision, false).cells > small) return 1;
        return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, design_.points.size());
    }

    std::unique_ptr<Backend> worker(const Machine& machine) const {
        if (!machine.opencl) return reference_backend(options_.run.precision);
        OpenclOptions wanted = *machine.opencl;
        wanted.units = 1;
        return opencl_backend(wanted);
    }

    // False: interrupted. What goes wrong in one tile ends all.
    bool run_tiles(const Machine& machine, Clock::time_point start) {
        const Bar bar(options_.run.quiet);
        const std::size_t all = design_.points.size(), side_by_side = jobs(machine);
        std::atomic<std::size_t> next = 0;
        std::atomic<bool> ending = false;
        std::exception_ptr failure;
        const auto work = [&](Backend& backend) {
            for (std::size_t tile = next++; tile < all && !ending; tile = next++) {
                if (taken_up(tile)) continue;
                try {
                    if (Interrupt::came() || !take(backend, tile)) ending = true;
                } catch (...) {
                    const std::lock_guard lock(guard_);
                    if (!failure) failure = std::current_exception();
                    ending = true;
                }
                const std::lock_guard lock(guard_);
                bar.show(table_.size(), all, seconds_since(start) / std::max(1.0, static_cast<double>(run_)));
            }
        };
        if (side_by_side == 1) {
            work(*machine.backend);
        } else {
            std::vector<std::unique_ptr<Backend>> backends;
            for (std::size_t i = 0; i < side_by_side; ++i) backends.push_back(worker(machine));
            std::vector<std::jthread> threads;
            for (const auto& backend : backends) threads.emplace_back([&] { work(*backend); });
        }
        if (failure) std::rethrow_exception(failure);
        return !ending;
    }

    bool taken_up(std::size_t tile) {
        const std::lock_guard lock(guard_);
        return table_.has(tile) && (table_.verdict(tile) == name_of(stats::Verdict::unstable) || has_files(tile));
    }

    Experiment experiment_of(std::size_t tile) const {
        const sweep::Point& point = design_.points[tile];
        std::vector<Setting> settings = settings_of(options_.run.settings);
        settings.insert(settings.end(), point.settings.begin(), point.settings.end());
        Experiment experiment = read_experiment(options_.run.file, nullptr, StartPictures::read, settings);
        if (options_.run.seed) experiment.seed = options_.run.seed;
        if (seeded_by_clock(experiment))
            throw Error(
                fmt::format("{}: the seed comes from the clock; give one with --seed, so that tiles can be "
                            "repeated",
                            experiment.source));
        if (point.replicate > 0) experiment.seed = experiment.run_seed() + static_cast<std::int64_t>(point.replicate);
        return experiment;
    }

    // Before the first tile runs: what only a late one would stumble over.
    void check_ranges() const {
        for (const sweep::Point& point : design_.points) {
            for (const Setting& one : point.settings) {
                const auto parameter = std::ranges::find(first_.parameters, one.name, &Parameter::name);
                const double value = std::stod(one.value);
                if (parameter == first_.parameters.end() || (value >= parameter->low && value <= parameter->high))
                    continue;
                throw Error(
                    fmt::format("--vary {}: {} is out of range; parameter '{}' must be a number from {:g} to {:g}",
                                one.name, one.value, one.name, parameter->low, parameter->high));
            }
        }
    }

    Machine choose() const {
        const Footprint needed = footprint(first_, last_, options_.run.precision, false);
        check_cells(first_, needed);
        Machine machine = choose_machine(options_.run, first_, needed);
        check_host_memory(first_, needed, worked(machine), usable_memory());
        return machine;
    }

    bool trusted(const Machine& machine) const {
        if (!machine.opencl || options_.run.no_self_test) return true;
        const auto [fault, note] =
            self_check(*machine.opencl, machine.info, first_, initial_state(first_, options_.run.precision), last_);
        if (!fault.empty()) say(stderr, "pelage: {}\n", fault);
        return fault.empty();
    }

    // What makes two sweeps one.
    std::string identity() const {
        std::string text = first_.text + fmt::format("\n{} {} {}\n", last_, options_.run.seed.value_or(0),
                                                     options_.run.precision == Precision::double_ ? "double" : "float");
        text += fmt::format("{} {}\n", fmt::join(options_.until, " "), fmt::join(options_.run.settings, " "));
        for (const sweep::Point& point : design_.points) {
            for (const Setting& one : point.settings) text += fmt::format("{}={} ", one.name, one.value);
            text += fmt::format("{}\n", point.replicate);
        }
        return sha256(text);
    }

    // Notes in the folder whose it is; throws where another sweep's results lie there.
    void claim() const {
        const fs::path mark = folder_ / ".pelage-sweep";
        if (!fs::exists(mark)) {
            if (fs::exists(folder_ / "sweep.csv"))
                throw Error(fmt::format("{} holds a sweep.csv that no sweep of ours left; choose another --out",
                                        folder_.string()));
            return write_file(mark, identity() + "\n");
        }
        if (read_file(mark) == identity() + "\n") return;
        throw Error(
            fmt::format("{} holds another sweep, or this one before its experiment or options changed; choose "
                        "another --out, or remove it",
                        folder_.string()));
    }

    void announce(const Machine& machine) const {
        if (options_.run.quiet) return;
        say(stderr, "{}: {}, {} each\n", first_.source, counted(design_.points.size(), "tile"),
            counted(last_, "iteration"));
        say(stderr, "backend: {} ({}), {}\n", machine.kind, machine.device,
            options_.run.precision == Precision::double_ ? "double" : "float");
        if (table_.size() > 0) say(stderr, "{} are there already\n", counted(table_.size(), "tile"));
    }

    // False: interrupted.
    bool take(Backend& backend, std::size_t tile) {
        const Clock::time_point start = Clock::now();
        const Experiment experiment = experiment_of(tile);
        sweep::check_measurable(experiment);
        const Snapshot initial = initial_state(experiment, options_.run.precision);
        std::optional<sweep::TileResult> result;
        if (!options_.run.force && find_instability(experiment, initial)) {
            result.emplace();
            result->verdict = stats::Verdict::unstable;
        } else {
            const auto tissue = backend.make_tissue(experiment, initial);
            result = sweep::run_tile(*tissue, experiment, {last_, steady_, Interrupt::came});
            if (!result) return false;
            keep(experiment, tile, result->state);
        }
        const double seconds = seconds_since(start);
        const std::lock_guard lock(guard_);
        ++run_;
        table_.add(tile, design_.points[tile], experiment.run_seed(), *result, seconds);
        return true;
    }

    // Those that the sheet and --format want; of arrays nothing is known here.
    bool has_files(std::size_t tile) const {
        if (!fs::exists(values_of(tile))) return false;
        if (options_.run.formats.empty()) return true;
        const auto there = [&](Format format) {
            const char* ending = format == Format::png   ? "png"
                                 : format == Format::exr ? "exr"
                                 : format == Format::csv ? "csv"
                                                         : "vti";
            return format == Format::npy || fs::exists(folder_ / "tiles" / fmt::format("{}.{}", tile, ending));
        };
        return std::ranges::all_of(options_.run.format_list(), there);
    }

    fs::path values_of(std::size_t tile) const { return folder_ / "tiles" / fmt::format(".{}.npy", tile); }

    void keep(const Experiment& experiment, std::size_t tile, const Snapshot& state) const {
        write_npy(values_of(tile), {state.rows, state.columns}, sweep::shown(experiment, state), NpyType::float32);
        if (options_.run.formats.empty()) return;
        ResultOptions what;
        what.formats = options_.run.format_list();
        what.precision = options_.run.precision;
        what.attributes["experiment"] = experiment.text;
        what.attributes["seed"] = std::to_string(experiment.run_seed());
        write_results(folder_ / "tiles", std::to_string(tile), state, experiment, what);
    }

    int stopped() const {
        say(stderr, "pelage: stopped after {} of {} tiles; the same command goes on\n", table_.size(),
            design_.points.size());
        return interrupted;
    }

    int finish(std::size_t run, double seconds) {
        table_.sort();
        std::vector<sweep::TilePicture> tiles;
        for (std::size_t tile = 0; tile < design_.points.size(); ++tile) {
            sweep::TilePicture picture;
            if (fs::exists(values_of(tile))) {
                const NpyArray array = read_npy(values_of(tile));
                picture = {array.shape.at(1), array.shape.at(0), array.values};
            }
            tiles.push_back(std::move(picture));
        }
        const std::string note = draw_sheet(folder_, first_, design_.axes, options_.replicates, tiles, options_.sheet,
                                            fmt::format("{}, iteration {}", first_.source, last_));
        if (options_.run.quiet) return success;
        if (!note.empty()) say(stderr, "note: {}\n", note);
        say("{}\n", verdicts());
        if (run > 0) say("{} in {:.3g} s\n", counted(run, "tile"), seconds);
        say("Results are in {}\n", folder_.string());
        return success;
    }

    // "120 stationary, 70 uniform, 2 unstable (their time step is too large; --force runs them all the same)"
    std::string verdicts() const {
        std::map<std::string, std::size_t> counts;
        for (std::size_t tile = 0; tile < design_.points.size(); ++tile) ++counts[table_.verdict(tile)];
        std::vector<std::string> parts;
        for (const auto& [verdict, count] : counts) {
            const char* remark =
                verdict == "unstable" ? " (their time step is too large; --force runs them all the same)" : "";
            parts.push_back(fmt::format("{} {}{}", grouped(count), verdict, remark));
        }
        return fmt::format("{}", fmt::join(parts, ", "));
    }

    const SweepOptions& options_;
    Design design_;
    std::optional<double> steady_;
    fs::path folder_;
    Experiment first_;
    sweep::Table table_;
    std::mutex guard_;     // of the table and the count
    std::size_t run_ = 0;  // tiles, this time
    std::uint64_t last_ = 0;
};

}  // namespace

int run_sweep(const SweepOptions& options) {
    if (options.run.file == standard_input) throw Error("a sweep reads its experiment for every tile; give a file");
    return Sweep(options).carry_out();
}

}  // namespace pelage::app
