// See sweeper.hpp.
#include "app/sweeper.hpp"

#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/last_will.hpp"
#include "app/machine.hpp"
#include "app/memory.hpp"
#include "app/prepare.hpp"
#include "app/read_experiment.hpp"
#include "app/say.hpp"
#include "app/self_check.hpp"
#include "app/settings.hpp"
#include "app/sweep_design.hpp"
#include "app/sweep_sheet.hpp"
#include "app/sweep_workers.hpp"
#include "app/tile_bar.hpp"
#include "app/tile_runner.hpp"
#include "cluster/together.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"
#include "io/locked.hpp"
#include "io/npy.hpp"
#include "io/sha256.hpp"
#include "sweep/share.hpp"
#include "sweep/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

class Sweep {
public:
    Sweep(const SweepOptions& options, std::string text, cluster::Ranks* ranks)
        : options_(options),
          text_(std::move(text)),
          design_(sweep_design(options, experiment_of(text_, options.run.file, StartPictures::left_out,
                                                      settings_of(options.run.settings)))),
          folder_(options.run.folder()),
          table_(folder_ / "sweep.csv", design_.names),
          runner_(options_, design_, text_, table_),
          first_(runner_.experiment(0)),
          last_(runner_.last_iteration(first_)),
          ranks_(ranks) {
        check_ranges(options_, design_, first_);
    }

    // The machines of this rank; none: one failed its self-test.
    std::vector<Machine> choose() const {
        if (!options_.run.formats.empty()) check_formats(options_.run, first_);
        const auto [largest, needed] = largest_tile();
        check_cells(largest, needed);
        std::vector<Machine> machines = sweep_machines(options_.run, first_, needed, ranks_);
        crews_of(machines);  // what they cannot do is said before anything is written
        for (const Machine& machine : machines) {
            check_host_memory(largest, needed, worked(machine), usable_memory());
            if (!trusted(machine)) return {};
        }
        return machines;
    }

    // What the rank that has the table does.
    int deal(std::vector<Machine>& machines) {
        const Interrupt interrupt;
        const Clock::time_point start = Clock::now();
        const TileBar bar(options_.run.quiet);
        sweep::Dealer dealer(
            table_, design_.points.size(), [this](std::size_t tile) { return taken_up(tile); },
            [&](std::size_t run) {
                const double spent = std::chrono::duration<double>(Clock::now() - start).count();
                bar.show(table_.size(), design_.points.size(), spent / static_cast<double>(run));
            });
        {
            const Workers workers(crews_of(machines), dealer, runner_);
            if (ranks_ != nullptr) dealer.serve(*ranks_);
        }
        bar.clear();
        if (dealer.failure()) std::rethrow_exception(dealer.failure());
        if (dealer.ended()) return stopped();
        return finish(dealer.run(), std::chrono::duration<double>(Clock::now() - start).count());
    }

    // What another one does.
    int play(std::vector<Machine>& machines) {
        const Interrupt interrupt;
        sweep::Player player(*ranks_);
        { const Workers workers(crews_of(machines), player, runner_); }
        player.leave();
        return success;
    }

    // Makes the folder, or takes one that holds the same sweep. While the lock lives, no other sweep can.
    std::unique_ptr<FolderLock> claim(std::vector<Machine>& machines) {
        prepare_folder(folder_ / "tiles");
        auto lock = std::make_unique<FolderLock>(folder_);
        mark();
        table_.take_up(design_.points);
        announce(machines);
        return lock;
    }

private:
    // The one that needs most, of all tiles or of so many spread over them; each is read, so that what is wrong with it
    // is said before the first one runs.
    std::pair<Experiment, Footprint> largest_tile() const {
        constexpr std::size_t most = 2000;
        std::pair<Experiment, Footprint> found{first_, footprint(first_, last_, options_.run.precision, false)};
        const std::size_t stride = (design_.points.size() + most - 1) / most;
        for (std::size_t tile = stride; tile < design_.points.size(); tile += stride) {
            Experiment experiment = runner_.named_experiment(tile);
            const Footprint needed =
                footprint(experiment, runner_.last_iteration(experiment), options_.run.precision, false);
            if (needed.cells > found.second.cells) found = {std::move(experiment), needed};
        }
        return found;
    }

    std::vector<Crew> crews_of(std::vector<Machine>& machines) const {
        const TileSize size{footprint(first_, last_, options_.run.precision, false), last_, design_.points.size()};
        std::vector<Crew> crews;
        for (Machine& machine : machines) crews.push_back(crew(machine, options_, size, ranks_));
        return crews;
    }

    bool taken_up(std::size_t tile) const {
        return table_.has(tile) &&
               (table_.verdict(tile) == name_of(stats::Verdict::unstable) || runner_.has_files(tile));
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
        for (const InputFile& input : first_.inputs) text += fmt::format("{} {}\n", input.name, input.sha256);
        for (const sweep::Point& point : design_.points) {
            for (const Setting& one : point.settings) text += fmt::format("{}={} ", one.name, one.value);
            text += fmt::format("{}\n", point.replicate);
        }
        return sha256(text);
    }

    // Notes in the folder whose it is; throws where another sweep's results lie there.
    void mark() const {
        const fs::path named = folder_ / ".pelage-sweep";
        if (!fs::exists(named)) {
            if (fs::exists(folder_ / "sweep.csv"))
                throw Error(fmt::format("{} holds a sweep.csv that no sweep of ours left; choose another --out",
                                        folder_.string()));
            return write_file(named, identity() + "\n");
        }
        if (read_file(named) == identity() + "\n") return;
        throw Error(
            fmt::format("{} holds another sweep, or this one before its experiment, options or input files changed; "
                        "choose another --out, or remove it",
                        folder_.string()));
    }

    void announce(std::vector<Machine>& machines) const {
        if (options_.run.quiet) return;
        say(stderr, "{}: {}, {} each\n", first_.source, counted(design_.points.size(), "tile"),
            counted(last_, "iteration"));
        for (const Crew& crew : crews_of(machines)) {
            const std::string together =
                crew.batch > 1 ? fmt::format(", up to {} tiles of one structure together", grouped(crew.batch)) : "";
            say(stderr, "backend: {} ({}), {}{}\n", crew.machine.kind, crew.machine.device,
                options_.run.precision == Precision::double_ ? "double" : "float", together);
        }
        std::size_t there = 0;
        for (std::size_t tile = 0; tile < design_.points.size(); ++tile) there += taken_up(tile) ? 1 : 0;
        if (there > 0)
            say(stderr, "{} of {} are there already\n", grouped(there), counted(design_.points.size(), "tile"));
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
            if (auto values = runner_.values_there(tile))
                picture = {values->shape.back(), values->shape.rbegin()[1], std::move(values->values)};
            tiles.push_back(std::move(picture));
        }
        const std::string note = draw_sheet(folder_, first_, design_.axes, options_.replicates, tiles, options_.across,
                                            options_.sheet, fmt::format("{}, iteration {}", first_.source, last_));
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
    std::string text_;
    SweepDesign design_;
    fs::path folder_;
    sweep::Table table_;
    TileRunner runner_;
    Experiment first_;
    std::uint64_t last_ = 0;  // iteration of the first tile
    cluster::Ranks* ranks_;
};

int carry_out(const SweepOptions& options, cluster::Ranks* ranks) {
    const bool deals = ranks == nullptr || ranks->rank() == 0;
    std::string text;
    std::optional<Sweep> sweep;
    std::vector<Machine> machines;
    std::unique_ptr<FolderLock> lock;
    cluster::together(ranks, [&] {
        if (deals) text = experiment_text(options.run.file);
    });
    if (ranks != nullptr) text = ranks->gather(text).front();
    cluster::together(ranks, [&] { sweep.emplace(options, text, ranks); });
    cluster::together(ranks, [&] { machines = sweep->choose(); });
    bool trusted = !machines.empty();
    if (ranks != nullptr)
        trusted = std::ranges::none_of(ranks->gather(trusted ? "" : "no"), [](auto& t) { return !t.empty(); });
    if (!trusted) return failed_check;
    cluster::together(ranks, [&] {
        if (deals) lock = sweep->claim(machines);
    });
    return deals ? sweep->deal(machines) : sweep->play(machines);
}

}  // namespace

int run_sweep(const SweepOptions& options) {
    when_killed_say("pelage: stopped before the sweep began\n");
    const std::unique_ptr<cluster::Ranks> ranks = cluster::join_ranks();
    try {
        return carry_out(options, ranks.get());
    } catch (const cluster::FirstReason& reason) {
        say(stderr, "pelage: {}\n", reason.what());
        ranks->gather("");
        return bad_input;
    } catch (const cluster::AnotherSaysWhy&) {
        ranks->gather("");
        return bad_input;
    }
}

}  // namespace pelage::app
