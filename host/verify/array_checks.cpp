// See check.hpp: experiments generated from what the program declares, see array_factors.hpp.
#include "core/counted.hpp"
#include "core/prepattern.hpp"
#include "reference/backend.hpp"
#include "verify/array_text.hpp"
#include "verify/blame.hpp"
#include "verify/bounded.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace pelage::verify {

namespace {

constexpr std::size_t pairs = 2;
constexpr std::size_t triples = 3;
constexpr std::size_t strides_if_small = 2;
constexpr std::size_t most_taken_up = 10'000;  // cells of a state that is taken up again: of more, it takes too long

std::size_t several(const Place& place) {
    // CPUs run one work-item a group, other devices 64 at most.
    const std::size_t group = place.device().type == "cpu" ? 3 : 16;
    return std::min(group, place.device().max_work_group);
}

void set_small_cut(Setting& setting, Realm realm) {
    const bool tiled = setting.path == Path::tiled, volume = realm == Realm::volume;
    setting.columns = volume ? 0 : tiled ? 12 : 32;
    setting.rows = volume ? 1 : tiled ? 5 : 2;  // of a volume's strips: as few as they may have
    setting.depth = volume ? 5 : 3;
}

Setting setting_of(const GeneratedWorld& made, Realm realm, const Place& place) {
    const Values world(realm, made.world);
    Setting setting;
    for (const Path one : {Path::shared, Path::streamed, Path::tiled}) {
        if (world.has("path", word(one))) setting.path = one;
    }
    const std::size_t others[] = {4, 2, 8};
    if (world.has("width", "1")) setting.width = 1;
    if (world.has("width", "other")) setting.width = others[made.number % 3];
    setting.variants = world.has("intervals", "compiled") ? 1 : 0;
    setting.precision = world["precision"] == "double" ? Precision::double_ : Precision::single_;
    if (world.has("group", "several") || world.has("items", "several"))
        setting.work_group = setting.group = several(place);
    if (world.has("items", "eight")) setting.work_group = std::min<std::size_t>(8, place.device().max_work_group);
    if (world.has("search", "sorting")) setting.search = NeighbourSearch::spatial_sorting;
    if (world.has("cut", "small")) set_small_cut(setting, realm);
    return setting;
}

// The world in the words that differ from world to world.
std::string described(const Values& world) {
    std::string text;
    for (std::size_t i = 0; i < world_factors(world.realm()); ++i) {
        const std::string& name = factors_of(world.realm())[i].name;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, world[name]);
    }
    return text;
}

class GeneratedCheck {
public:
    GeneratedCheck(Place& place, const GeneratedWorld& made, Realm realm)
        : place_(place), made_(made), realm_(realm), setting_(setting_of(made, realm, place)) {}

    Outcome run() {
        if (setting_.precision == Precision::double_ && !place_.device().fp64) {
            return {Verdict::skipped, {}, "the device has no numbers of double precision", {}};
        }
        const std::vector<Size> sizes = generated_sizes(made_, realm_);
        for (const Size& size : sizes) follow({&made_, realm_, size, place_.seed()}, &size == &sizes.back());
        conclude();
        return std::move(outcome_);
    }

private:
    void follow(const GeneratedCase& one, bool last) {
        const std::string text = generated_text(one);
        const Experiment experiment = generated_experiment(one, text);
        Snapshot state = initial_state(experiment, setting_.precision);
        if (place_.small() && state.cells() > small_cells) return;
        set_stage(one, state);
        const auto expected = reference_backend(setting_.precision, setting_.search)->make_tissue(experiment, state);
        const auto found = place_.backend(setting_).make_tissue(experiment, state);
        std::vector<Snapshot> states{state};
        std::vector<std::uint64_t> strides = generated_strides(one.size, realm_);
        if (place_.small()) strides.resize(strides_if_small);
        for (const std::uint64_t stride : strides) {
            expected->advance(stride);
            found->advance(stride);
            states.push_back(expected->read());
            const Snapshot there = found->read();
            const bool equal_before = outcome_.tally.equal();
            const std::string when = fmt::format("{}, {} after the start", one.size.text(),
                                                 counted(states.back().iteration - state.iteration, "iteration"));
            add(outcome_.tally, states.back(), there, setting_.precision, when);
            if (!equal_before || outcome_.tally.equal()) continue;
            note_difference(text, states.back(), there, when);
            if (blame_.empty() && rounds_exactly(place_, setting_))
                blame_ = blame({experiment, text, state, states.back().iteration - state.iteration}, place_, setting_);
        }
        if (last && !place_.small() && state.cells() <= most_taken_up)
            take_up_again(experiment, states, one.size.text());
        if (states.back().conc != state.conc) changed_ = true;
        if (!rounds_exactly(place_, setting_)) one_by_one(experiment, states);
    }

    // As a run that was stopped after its second stride, and then without a stop. Later ones would need more programs.
    void take_up_again(const Experiment& experiment, const std::vector<Snapshot>& states, const std::string& size) {
        if (!outcome_.tally.equal()) return;
        const Snapshot& stopped = states[std::min<std::size_t>(2, states.size() - 2)];
        const std::uint64_t begun = stopped.iteration - states.front().iteration;
        const auto found = place_.backend(setting_).make_tissue(experiment, stopped);
        found->advance(states.back().iteration - stopped.iteration);
        add(outcome_.tally, states.back(), found->read(), setting_.precision,
            fmt::format("{}, taken up again {} iterations after the start", size, begun));
    }

    void note_difference(const std::string& text, const Snapshot& expected, const Snapshot& found,
                         const std::string& when) {
        text_ = text;
        if (expected.columns == 0 || expected.cells() != found.cells()) return;
        std::size_t chemical = 0;
        while (chemical + 1 < expected.conc.size() && expected.conc[chemical] == found.conc[chemical]) ++chemical;
        if (outcome_.evidence && expected.cells() < enough_cells) return;
        // The layers of a volume one above the other.
        outcome_.evidence =
            Evidence{fmt::format("conc[{}], {}", chemical, when), expected.columns, expected.cells() / expected.columns,
                     expected.conc[chemical], found.conc[chemical]};
    }

    // Where the device's divisions are not exact: one iteration from each of the reference's states.
    void one_by_one(const Experiment& experiment, const std::vector<Snapshot>& states) {
        if (outcome_.tally.equal()) return;
        outcome_.tally = single_iterations(experiment, states, place_, setting_);
        if (!within_bound(outcome_.tally)) return;
        outcome_.message = bound_message();
        outcome_.tally = {};
    }

    void conclude() {
        const std::string what = described({realm_, made_.world});
        if (!outcome_.tally.equal()) {
            outcome_.verdict = Verdict::failed;
            outcome_.message = fmt::format("{}\n{}the experiment, from iteration {} on:\n{}", what, blame_,
                                           Values(realm_, made_.world)["start"], text_);
        } else if (!changed_) {
            outcome_.verdict = place_.small() ? Verdict::skipped : Verdict::mistrusted;
            outcome_.message = place_.small() ? "left out with --small" : what + ": nothing changes";
        }
    }

    Place& place_;
    const GeneratedWorld& made_;
    Realm realm_;
    Setting setting_;
    Outcome outcome_;
    std::string text_;   // of the experiment that differed first
    std::string blame_;  // which of its rules that needs
    bool changed_ = false;
};

std::string kernel_of(const Values& world) {
    if (world.realm() == Realm::cells) return "generated cells";
    if (world.realm() == Realm::volume) return "volumes";
    if (world.realm() == Realm::mesh) return "mesh step";
    if (world.realm() == Realm::charges) return "aggregates";
    const std::string& path = world["path"];
    if (path == "streamed") return "streamed steps";
    if (path == "tiled") return "tiled steps";
    return path == "shared" ? "shared steps" : "single steps";
}

// What a name tells of the world.
std::string marks_of(const Values& world) {
    if (world.realm() == Realm::mesh) return "-" + world["shape"] + "-" + world["weights"];
    const bool grid = world.realm() == Realm::lattice || world.realm() == Realm::volume;
    return "-" + world["path"] + (grid ? "-" + world["stencil"] + "-" + world["boundary"] : "");
}

}  // namespace

std::vector<Check> array_checks(bool full) {
    std::vector<Check> checks;
    for (const std::size_t strength : {pairs, triples}) {
        if (strength == triples && !full) continue;  // it takes a moment to find them
        for (const Realm realm : every_realm) {
            for (std::size_t nth = 0; nth < world_count(realm, strength); ++nth) {
                const Values world(realm, world_row(realm, strength, nth));
                const char* const kind = strength == pairs ? "pairs" : "triples";
                checks.push_back({fmt::format("{}/{}/{}{}", kind, word(realm), nth, marks_of(world)), kernel_of(world),
                                  strength == pairs, [=](Place& place) {
                                      const auto& worlds = generated_worlds(realm, strength);
                                      return GeneratedCheck(place, worlds[nth], realm).run();
                                  }});
            }
        }
    }
    return checks;
}

}  // namespace pelage::verify
