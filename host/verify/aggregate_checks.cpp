// See check.hpp: aggregates, whose sites and potentials are those of the reference after every stretch.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pelage::verify {

namespace {

constexpr std::array<std::uint64_t, 5> stretches{1, 2, 60, 257, 340};
constexpr std::size_t stretches_if_small = 3;

struct AggregateCase {
    const char* name;
    const char* size;
    const char* seed;  // where charges are at the start
    const char* rules;
    bool quick = false;  // others are left to the generated ones
    bool large = false;  // too large for a simulator
};

// Seeds in a corner, few and many; no more candidates than a block of weights holds, and several blocks of them; every
// parameter, as a number and as an expression; a lattice that is full in the end; walls with doors, and seeds whose
// descent is kept; charges of many sizes; more candidates than 15 bits count, and in the share of each group as well.
// With a far field: several levels of blocks, none of them and one row of them; draws that are all rejected, when the
// last candidates have the same potential; bounds that are made anew for another eta in each iteration; corridors, at
// whose ends a few great charges put the highest potentials beside a block that has none as high; many candidates, too;
// charges so small that the last digits of what far ones add count.
constexpr std::array<AggregateCase, 18> aggregate_cases{{
    {"aggregates/point", "61 47", "COLUMN == 30 and ROW == 23", "rule always aggregate order phi eta 3\n"},
    {"aggregates/corner", "97 5", "COLUMN == 0 and ROW == 0", "rule always aggregate order phi eta 1\n"},
    {"aggregates/even", "40 37", "RANDOM < 0.02", "rule always aggregate order phi eta 0\n"},
    {"aggregates/cross", "121 120", "COLUMN == 60 or ROW == 60", "rule always aggregate order phi eta 10 radius 2\n"},
    {"aggregates/towards", "90 71", "abs(hypot(COLUMN - 45, ROW - 35) - 15) < 0.5",
     "rule always aggregate order phi eta (1 + ITERATION / 100) radius (2 + TIME / 50)"
     " towards (ITERATION - 40) 30 strength 3\n"},
    {"aggregates/full", "19 11", "COLUMN == 4 and ROW > 7",
     "rule every 2 always aggregate order phi eta 6\nrule from 50 always aggregate order phi eta 2.5\n"},
    {"aggregates/walls", "83 41 where (mod(COLUMN, 9) != 8 or ROW == mod(7 * COLUMN, 41))",
     "mod(COLUMN, 36) == 3 and ROW == 20", "rule always aggregate order phi eta 2 seed family\n"},
    {"aggregates/sizes", "88 75", "RANDOM < 0.001 or ROW == COLUMN and ROW == 30",
     "rule always aggregate order phi eta 4 size mass (0.01 + 20 * RANDOM ^ 3) towards 20 0 strength 5\n"},
    {"aggregates/many", "317 316", "RANDOM < 0.055", "rule always aggregate order phi eta 2\n", true, true},
    {"aggregates/very-many", "301 299", "mod(COLUMN, 3) == 1 and mod(ROW, 3) == 1",
     "rule always aggregate order phi eta 2\n", false, true},
    {"aggregates/far-field", "141 117", "COLUMN == 70 and ROW == 58 or RANDOM < 0.0005",
     "rule always aggregate order phi eta 3 far-field\n"},
    {"aggregates/far-full", "13 12", "COLUMN == 4 and ROW == 7",
     "rule every 2 always aggregate order phi eta 6 far-field\nrule from 30 always aggregate order phi eta 2.5 "
     "far-field\n",
     true},
    // So many charges at the start that bounds were made anew one charge before.
    {"aggregates/far-begun", "88 37", "COLUMN < 87 and mod(COLUMN, 3) == 1 and ROW < 36 and mod(ROW, 4) == 2",
     "rule always aggregate order phi eta 3 far-field\n", true, true},
    {"aggregates/far-walls", "300 9 where (mod(COLUMN, 9) != 8 or ROW == mod(7 * COLUMN, 9))",
     "mod(COLUMN, 90) == 3 and ROW == 4", "rule always aggregate order phi eta 2 seed family far-field\n"},
    {"aggregates/far-sizes", "88 75", "RANDOM < 0.001 or ROW == COLUMN and ROW == 30",
     "rule always aggregate order phi eta (ITERATION / 40) size mass (0.01 + 20 * RANDOM ^ 3) far-field\n", true},
    {"aggregates/far-corridors", "150 90 where (mod(ROW, 2) == 0)", "COLUMN == 70 and mod(ROW, 2) == 0",
     "rule always aggregate order phi eta 8 size mass (0.01 + 990 * RANDOM ^ 30) far-field\n", true},
    {"aggregates/far-many", "301 299", "mod(COLUMN, 3) == 1 and mod(ROW, 3) == 1",
     "rule always aggregate order phi eta 2 far-field\n", false, true},
    {"aggregates/far-slight", "120 100", "mod(COLUMN, 40) == 7 and mod(ROW, 45) == 3",
     "set cells where (mod(COLUMN, 40) == 7 and mod(ROW, 45) == 3) chemical mass conc 0.001\n"
     "rule always aggregate order phi eta 2 size mass (0.001 + 0.001 * RANDOM) far-field\n"},
}};

Experiment experiment_of(const AggregateCase& one) {
    const std::string text = fmt::format(
        "define chemical order\ndefine chemical phi\ndefine chemical family\ndefine chemical mass\nuse seed 7\ncreate "
        "charges {}\n"
        "set cells where ({}) chemical order conc (1 + mod(COLUMN + ROW, 3))\n{}",
        one.size, one.seed, one.rules);
    return parse_experiment(text, one.name, ".");
}

// Which site comes next is no number that may be nearly right: fast arithmetic is not taken here.
Outcome check_fast_aggregate(Place& place) {
    OpenclOptions options;
    options.device = std::to_string(place.device().index);
    options.guarded = true;
    options.fast = true;
    const Experiment experiment = experiment_of(aggregate_cases.front());
    const Snapshot initial = initial_state(experiment, Precision::single_);
    const auto expected = reference_backend(Precision::single_)->make_tissue(experiment, initial);
    const auto found = opencl_backend(options)->make_tissue(experiment, initial);
    Outcome outcome;
    for (const std::uint64_t steps : std::span(stretches).first(stretches_if_small)) {
        expected->advance(steps);
        found->advance(steps);
        add(outcome.tally, expected->read(), found->read(), Precision::single_,
            fmt::format("fast, iteration {}", found->iteration()));
    }
    conclude(outcome);
    return outcome;
}

Outcome check_aggregate(const AggregateCase& one, Place& place) {
    if (place.small() && one.large) return {Verdict::skipped, {}, "left out with --small", {}};
    const std::size_t group = std::min<std::size_t>(8, place.device().max_work_group);
    std::vector<Setting> settings{{}, {.path = Path::shared, .work_group = group}};
    if (place.small()) settings.front().work_group = group;
    if (place.full()) {
        settings.push_back({.work_group = group});
        settings.push_back({.path = Path::shared});
        settings.push_back({.path = Path::automatic});
        settings.push_back({.guarded = false});
    }
    if (one.large && place.loop_limit() != 0) settings.resize(1);  // one group would go through too many places
    const bool few = place.small() || (one.large && !place.full());
    return beside_the_reference(place, place.seeded(experiment_of(one)), settings,
                                std::span(stretches).first(few ? stretches_if_small : stretches.size()));
}

}  // namespace

std::vector<Check> aggregate_checks() {
    std::vector<Check> checks;
    for (const AggregateCase& one : aggregate_cases) {
        checks.push_back(
            {one.name, "aggregates", one.quick, [&one](Place& place) { return check_aggregate(one, place); }});
    }
    checks.push_back({"aggregate/fast", "aggregates", false, check_fast_aggregate});
    return checks;
}

}  // namespace pelage::verify
