// See check.hpp: every lattice case of the table, as a run would step it and in other shapes of the work.
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "reference/backend.hpp"
#include "verify/bounded.hpp"
#include "verify/cases.hpp"
#include "verify/check.hpp"
#include "verify/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace pelage::verify {

namespace {

constexpr Size small_size{19, 11};  // where the case has none that proves something
constexpr Size small_volume{7, 6, 5};
constexpr std::uint64_t small_iterations = 4;
constexpr std::uint64_t quick_iterations = 50;
constexpr std::size_t many_sizes = 10;

// The cases that the quick form runs: each kernel path once, in the fewest programs. Volumes are in generated ones.
constexpr std::array<std::string_view, 25> quick_cases{"rules/whole-numbers/fused",
                                                       "diffusion/nine-point/no-flux",
                                                       "diffusion/nine-point/wrap",
                                                       "diffusion/nine-point/absorbing",
                                                       "diffusion/moore/wrap",
                                                       "diffusion/five-point/no-flux",
                                                       "diffusion/sims/absorbing",
                                                       "diffusion/5x5/wrap",
                                                       "diffusion/own-weights/absorbing",
                                                       "diffusion/published/open",
                                                       "diffusion/published/wrap",
                                                       "reaction/fused",
                                                       "reaction/published",
                                                       "saturation/fused",
                                                       "rates/uneven/nine-point/no-flux",
                                                       "rates/uneven/published/open",
                                                       "rates/polarized/five-point/absorbing",
                                                       "rules/quantities/fused",
                                                       "rules/draws/fused",
                                                       "rules/chains/published",
                                                       "growth/plain/absorbing",
                                                       "neural/no-flux",
                                                       "values/denormal/published",
                                                       "sizes/many-rows",
                                                       "sizes/many-columns-around"};
constexpr std::string_view strips = "sizes/strips";
// Of these also with a second work-group size, and on the other paths.
constexpr std::array<std::string_view, 2> quick_groups{"diffusion/nine-point/no-flux", "diffusion/published/open"};
// Of these the generated experiments have nearly all, with everything else that a rule may be.
constexpr std::array<std::string_view, 2> quick_streamed{"rules/keeping/fused", "rules/restless"};
constexpr std::array<std::string_view, 1> quick_shared{strips};
constexpr std::array<std::string_view, 1> quick_tiled{"diffusion/own-weights/no-flux"};

template <class List>
bool among(const std::string& name, const List& list) {
    return std::ranges::find(list, std::string_view(name)) != list.end();
}

std::string kernel_of(const std::string& name) {
    const auto begins = [&](const char* prefix) { return name.starts_with(prefix); };
    if (begins("reaction/")) return "reactions";
    if (begins("rates/uneven")) return "uneven rates";
    if (begins("rates/polarized")) return "polarity";
    if (begins("growth/")) return "expansion";
    if (begins("neural/")) return "networks";
    if (begins("values/")) return "special values";
    if (begins("sizes/")) return "diffusion";
    if (begins("volume/")) return "volumes";
    return name.substr(0, name.find('/'));
}

struct State {
    Snapshot before;
    std::vector<std::uint64_t> strides;
    std::vector<Snapshot> after;  // each stride, by the reference
};

// The first layer of a volume that differs; 0 elsewhere.
std::size_t different_layer(const Snapshot& expected, const Snapshot& found, std::size_t chemical) {
    const auto [place, other] = std::ranges::mismatch(expected.conc[chemical], found.conc[chemical]);
    const auto cell = static_cast<std::size_t>(place - expected.conc[chemical].begin());
    return std::min(cell, expected.cells() - 1) /
           (expected.volume() ? expected.columns * expected.rows : expected.cells());
}

std::vector<double> layer_of(const Snapshot& state, std::size_t chemical, std::size_t layer) {
    const std::vector<double>& values = state.conc.at(chemical);
    if (!state.volume()) return values;
    const auto size = static_cast<std::ptrdiff_t>(state.columns * state.rows);
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(layer) * size;
    return {first, first + size};
}

Snapshot first_state(const Case& one, const Experiment& experiment, Precision precision) {
    Snapshot state = initial_state(experiment, precision);
    if (one.touch) one.touch(state);
    return state;
}

class LatticeCheck {
public:
    // `fewer`: of many sizes every second, which are enough beside another check of the same case.
    LatticeCheck(const Case& one, Place& place, bool fewer = false) : case_(one), place_(place), fewer_(fewer) {}

    Outcome run(const std::vector<Setting>& settings) {
        if (case_.name.starts_with("values/") && !place_.subnormal_difference().empty()) {
            outcome_.verdict = Verdict::skipped;
            outcome_.message = place_.subnormal_difference();
            return std::move(outcome_);
        }
        run_sizes(settings);
        if (!outcome_.tally.equal() && case_.divides && !rounds_exactly(place_, {})) {
            outcome_ = {};
            doubts_.clear();
            bounded_ = true;
            run_sizes(settings);
        }
        conclude();
        return std::move(outcome_);
    }

private:
    void run_sizes(const std::vector<Setting>& settings) {
        for (const Size size : sizes()) {
            const Experiment experiment = place_.seeded(case_.experiment(size));
            for (const Precision precision : {Precision::single_, Precision::double_}) {
                run_size(experiment, size, precision, settings);
            }
        }
    }

    std::vector<Size> sizes() const {
        if (place_.full() && !fewer_) return case_.sizes;
        if (!place_.small()) return fewer();
        const auto cells = [](const Size& size) { return size.cells(); };
        std::vector<Size> chosen;
        for (const Size& size : case_.sizes) {
            if (cells(size) <= small_cells) chosen.push_back(size);
        }
        const bool proves = std::ranges::any_of(chosen, [&](const Size& size) { return cells(size) >= enough_cells; });
        if (!chosen.empty() && !proves) chosen.push_back(in_layers() ? small_volume : small_size);
        return chosen;
    }

    bool in_layers() const { return case_.sizes.front().layers != 0; }

    // Of many sizes every second: neighbours in the list are of one kind.
    std::vector<Size> fewer() const {
        if (case_.sizes.size() <= many_sizes) return case_.sizes;
        std::vector<Size> chosen;
        for (std::size_t i = 0; i < case_.sizes.size(); i += 2) chosen.push_back(case_.sizes[i]);
        return chosen;
    }

    void run_size(const Experiment& experiment, Size size, Precision precision, const std::vector<Setting>& settings) {
        const auto concerns = [&](const Setting& setting) { return setting.precision == precision; };
        if (std::ranges::none_of(settings, concerns)) return;
        const State state = by_reference(experiment, precision);
        const std::string where = size.text();
        if (precision == Precision::single_) weigh(state, size, where);
        bool again = !place_.small();  // the first of them twice, the second time unguarded
        for (const Setting& setting : settings) {
            if (!concerns(setting)) continue;
            const std::string text = setting.text().empty() ? where : where + ", " + setting.text();
            compare(experiment, state, setting, text);
            if (again) {
                Setting bare = setting;
                bare.guarded = false;
                compare(experiment, state, bare, where + ", " + bare.text());
            }
            again = false;
        }
    }

    State by_reference(const Experiment& experiment, Precision precision) const {
        const auto reference = reference_backend(precision);
        State state;
        state.before = first_state(case_, experiment, precision);
        const auto tissue = reference->make_tissue(experiment, state.before);
        const std::uint64_t most = place_.small()  ? small_iterations
                                   : place_.full() ? case_.iterations
                                                   : quick_iterations;
        const std::uint64_t all = std::min(case_.iterations, most);
        const std::uint64_t last = bounded_ ? 1 : all;
        for (std::uint64_t done = 0; done < last;) {
            const std::uint64_t count = done == 0 || case_.grows ? 1 : last - done;
            tissue->advance(count);
            state.strides.push_back(count);
            state.after.push_back(tissue->read());
            done += count;
        }
        return state;
    }

    void compare(const Experiment& experiment, const State& state, const Setting& setting, const std::string& where) {
        const auto tissue = place_.backend(setting).make_tissue(experiment, state.before);
        for (std::size_t i = 0; i < state.after.size(); ++i) {
            tissue->advance(state.strides[i]);
            const Snapshot found = tissue->read();
            const std::string when = fmt::format("{}, iteration {}", where, state.after[i].iteration);
            add(outcome_.tally, state.after[i], found, setting.precision, when);
            const bool tells_enough = outcome_.evidence && outcome_.evidence->expected.size() >= enough_cells;
            if (outcome_.tally.equal() || tells_enough) continue;
            Tally here;  // a picture of so few cells gives way to one of more that differ too
            add(here, state.after[i], found, setting.precision, when);
            if (!here.equal()) keep_evidence(state.after[i], found, when);
        }
    }

    void keep_evidence(const Snapshot& expected, const Snapshot& found, const std::string& when) {
        if (expected.cells() != found.cells()) return;
        std::size_t chemical = 0;
        while (chemical + 1 < expected.conc.size() && expected.conc[chemical] == found.conc[chemical]) ++chemical;
        outcome_.evidence = Evidence{fmt::format("conc[{}], {}", chemical, when), expected.columns, expected.rows,
                                     layer_of(expected, chemical, different_layer(expected, found, chemical)),
                                     layer_of(found, chemical, different_layer(expected, found, chemical))};
    }

    // A size of few cells may end flat without a doubt about the case; where it does not, it proves something, too.
    void weigh(const State& state, Size size, const std::string& where) {
        const bool enough = size.cells() >= enough_cells;
        const std::vector<std::string> found = mistrusted(state.before, state.after.back());
        trusted_ = trusted_ || enough || found.empty();
        if (!enough) return;
        for (const std::string& doubt : found) doubts_.push_back(where + ": " + doubt);
    }

    void conclude() {
        const Tally& tally = outcome_.tally;
        if (bounded_ && within_bound(tally)) {
            if (!tally.equal()) outcome_.message = bound_message();
        } else if (!tally.equal()) {
            outcome_.verdict = Verdict::failed;
        }
        if (outcome_.verdict != Verdict::passed) return;
        if (!doubts_.empty()) {
            outcome_.verdict = Verdict::mistrusted;
            outcome_.message = doubts_.front();
        } else if (!trusted_) {
            outcome_.verdict = Verdict::skipped;
            if (outcome_.message.empty()) {
                outcome_.message = place_.small() ? "left out with --small" : "no size that proves something was run";
            }
        }
    }

    const Case& case_;
    Place& place_;
    bool fewer_;
    Outcome outcome_;
    std::vector<std::string> doubts_;
    bool trusted_ = false;
    bool bounded_ = false;
};

std::vector<Setting> step_settings(const Case& one, const Place& place) {
    // The quick form compiles few programs: after the first set of rules one that tests at run time which of them act.
    std::vector<Setting> settings{{.variants = place.full() ? Setting{}.variants : 1}};
    // CPUs run one work-item a group, other devices 64 at most.
    const std::size_t second = place.device().type == "cpu" ? 3 : 16;
    const std::size_t group = std::min(second, place.device().max_work_group);
    if (!place.full()) {
        if (among(one.name, quick_groups)) settings.push_back({.work_group = group});
        return settings;
    }
    settings.push_back({.work_group = group, .width = 1, .variants = 0});
    if (place.device().fp64) settings.push_back({.precision = Precision::double_, .variants = 1});
    return settings;
}

// Another stencil's weights, which single steps have been through: long programs, all alike.
bool only_weights_differ(const std::string& name) {
    return name.find("/moore/") != std::string::npos || name.find("/sims/") != std::string::npos;
}

}  // namespace

std::vector<Check> lattice_checks() {
    std::vector<Check> checks;
    for (const Case& one : lattice_cases()) {
        const auto step = [&one](Place& place) { return LatticeCheck(one, place).run(step_settings(one, place)); };
        checks.push_back({one.name, kernel_of(one.name), among(one.name, quick_cases), step});
    }
    const auto add = [&](const char* prefix, const char* kernel, Setting setting, const auto& quick) {
        setting.variants = 1;
        for (const Case& one : lattice_cases()) {
            if (only_weights_differ(one.name) || one.name.starts_with("volume/")) continue;
            const auto run = [&one, setting](Place& place) { return LatticeCheck(one, place, true).run({setting}); };
            checks.push_back({prefix + one.name, kernel, among(one.name, quick), run});
        }
    };
    // Bands so narrow that the larger sizes have several with margins, and the smaller ones one without.
    add("streamed/", "streamed steps", {.path = Path::streamed, .columns = 32}, quick_streamed);
    add("tiled/", "tiled steps", {.path = Path::tiled}, quick_tiled);
    add("shared/", "shared steps", {.path = Path::shared}, quick_shared);
    // Without bands, strips share the passes of a launch.
    const auto whole_rows = [](Place& place) {
        return LatticeCheck(lattice_case(std::string(strips)), place).run({{.path = Path::streamed, .variants = 1}});
    };
    checks.push_back({"streamed/sizes/strips-of-whole-rows", "streamed steps", true, whole_rows});
    // Strips so narrow that the larger volumes have several; and as a run finds them out by itself.
    for (const Case& one : lattice_cases()) {
        if (!one.name.starts_with("volume/")) continue;
        const auto run = [&one](Place& place) {
            return LatticeCheck(one, place, true)
                .run({{.path = Path::streamed, .variants = 1, .rows = 7, .depth = 3},
                      {.path = Path::automatic, .variants = 1, .depth = 5}});
        };
        checks.push_back({"streamed/" + one.name, "volumes", false, run});
    }
    return checks;
}

}  // namespace pelage::verify
