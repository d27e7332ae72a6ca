// Which seed a charge descends from.
#include "core/aggregate.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using namespace pelage;

namespace {

// A patch and a point with a number, and two points without one.
Experiment rivals() {
    return parse_experiment(
        "define chemical order\ndefine chemical phi\ndefine chemical family\ncreate charges 60 51\n"
        "set cells where (COLUMN < 4 and ROW < 4) chemical order conc 2 chemical family conc 7.5\n"
        "set cells where (COLUMN == 50 and ROW == 40) chemical order conc 1 chemical family conc 3\n"
        "set cells where (ROW == 30 and mod(COLUMN, 30) == 12) chemical order conc 3\n"
        "set cells where (COLUMN == 33 and ROW == 2) chemical family conc 9\n"
        "rule always aggregate order phi seed family eta 3\nrule every 2 always aggregate order phi eta 1 seed "
        "family\n",
        "rivals.pex", ".");
}

// The charge beside a site that came first, and before the site's own; the site itself where there is none.
std::size_t parent_of(const Snapshot& state, std::size_t site) {
    const std::vector<double>& order = state.conc[0];
    std::size_t parent = site;
    for (std::size_t other = 0; other < order.size(); ++other) {
        const auto apart = [&](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
        const bool beside = apart(site % state.columns, other % state.columns) <= 1 &&
                            apart(site / state.columns, other / state.columns) <= 1;
        if (beside && order[other] > 0.0 && order[other] < order[parent]) parent = other;
    }
    return parent;
}

void check_descent(const Snapshot& start, const Snapshot& state) {
    double own = 0.0;  // of seeds, by their places in the order
    for (std::size_t site = 0; site < state.cells(); ++site) {
        INFO("site " << site);
        const double seed = state.conc[2][site];
        if (state.conc[0][site] == 0.0) {
            REQUIRE(seed == 0.0);
        } else if (start.conc[0][site] > 0.0) {
            REQUIRE(seed == (start.conc[2][site] > 0.0 ? start.conc[2][site] : state.conc[0][site]));
            own += 1.0;
        } else {
            REQUIRE(seed == state.conc[2][parent_of(state, site)]);
        }
    }
    CHECK(own == 19.0);
}

}  // namespace

TEST_CASE("a charge descends from the seed of the charge that came first beside it") {
    const Experiment experiment = rivals();
    const Snapshot start = initial_state(experiment);
    const auto reference = reference_backend(Precision::single_)->make_tissue(experiment);
    const auto device = opencl_backend()->make_tissue(experiment);
    for (const std::uint64_t steps : std::vector<std::uint64_t>{0, 1, 99, 500}) {
        reference->advance(steps);
        device->advance(steps);
        CHECK(verify::differences(reference->read(), device->read()).empty());
        check_descent(start, reference->read());
    }
    const Snapshot state = reference->read();
    const std::set<double> families(state.conc[2].begin(), state.conc[2].end());
    CHECK(families == std::set<double>{0.0, 3.0, 7.5, 18.0, 19.0});
    for (const double family : families) CHECK(std::ranges::count(state.conc[2], family) > 30);
}

TEST_CASE("descent is known to a run that goes on, and changes no site") {
    const Experiment experiment = rivals();
    Experiment silent = experiment;
    for (Rule& rule : silent.rules) std::get<Aggregate>(rule.action).seed.reset();
    for (const bool on_device : {false, true}) {
        const auto backend = on_device ? opencl_backend() : reference_backend(Precision::single_);
        const auto whole = backend->make_tissue(experiment);
        const auto plain = backend->make_tissue(silent);
        whole->advance(200);
        plain->advance(500);
        const Snapshot kept = whole->read();
        whole->advance(300);
        const auto part = backend->make_tissue(experiment, kept);
        CHECK(verify::differences(part->read(), kept).empty());
        part->advance(300);
        CHECK(verify::differences(part->read(), whole->read()).empty());
        CHECK(plain->read().conc[0] == whole->read().conc[0]);
        CHECK(plain->read().conc[1] == whole->read().conc[1]);
    }
}
