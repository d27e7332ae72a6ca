// Aggregates with a far field: the bound of the potentials over whole runs, the same sites on both backends, and from a
// state that was kept.
#include "core/aggregate.hpp"
#include "core/far_grid.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/aggregate/far_growth.hpp"
#include "reference/aggregate/growth.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace pelage;

namespace {

Experiment far_charges(const std::string& size, const std::string& seed, const std::string& rule) {
    return parse_experiment("define chemical order\ndefine chemical phi\ndefine chemical family\ndefine chemical mass\n"
                            "use seed 3\ncreate charges " +
                                size + "\nset cells where (" + seed +
                                ") chemical order conc 1\nrule always aggregate order phi " + rule + " far-field\n",
                            "far.pex", ".");
}

// The largest part of a sum of size / r over all charges that its candidate's potential is off by.
double largest_part_off(const Snapshot& state, bool sized) {
    const Front front(state, 0);
    double largest = 0.0;
    for (const std::uint32_t site : front.places()) {
        if (site == no_site) continue;
        double sum = 0.0;
        for (const std::uint32_t charge : front.charges()) {
            const double x = static_cast<double>(site % state.columns) - static_cast<double>(charge % state.columns);
            const double y = static_cast<double>(site / state.columns) - static_cast<double>(charge / state.columns);
            sum += (sized ? state.conc[3][charge] : 1.0) / std::hypot(x, y);
        }
        const double told = static_cast<double>(front.charges().size()) - state.conc[1][site];
        largest = std::max(largest, std::abs(told / sum - 1.0));
    }
    return largest;
}

}  // namespace

TEST_CASE("aggregates with a far field take the same sites on both backends") {
    const auto experiment = far_charges("250 200", "COLUMN == 125 and ROW == 100", "eta 3");
    const auto reference = reference_backend(Precision::single_)->make_tissue(experiment);
    const auto device = opencl_backend()->make_tissue(experiment);
    for (const std::uint64_t some : {1, 2, 60, 257, 700}) {
        reference->advance(some);
        device->advance(some);
        INFO("after " << reference->iteration());
        REQUIRE(verify::differences(reference->read(), device->read()).empty());
    }
}

TEST_CASE("with a far field every candidate's potential is within its bound over a whole run") {
    for (const bool sized : {false, true}) {
        const auto tissue = reference_backend(Precision::single_)
                                ->make_tissue(far_charges("250 200", "COLUMN == 125 and ROW == 100",
                                                          sized ? "eta 3 size mass (0.01 + 9 * RANDOM ^ 4)" : "eta 3"));
        double largest = 0.0;
        for (int part = 0; part < 12; ++part) {
            tissue->advance(250);
            const double off = largest_part_off(tissue->read(), sized);
            CHECK(off < far_bound);
            largest = std::max(largest, off);
        }
        CHECK(largest > 1e-7);  // there is something to be near to
        WARN("off by at most " << largest);
    }
}
