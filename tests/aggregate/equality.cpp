// Aggregates: the same sites and potentials on both backends, in one go and in pieces, and from a state that was kept.
#include "aggregate/direct_sum.hpp"
#include "core/aggregate.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace pelage;

namespace {

Experiment charges(const std::string& size, const std::string& seed, const std::string& rule) {
    return parse_experiment("define chemical order\ndefine chemical phi\ncreate charges " + size +
                                "\nset cells where (" + seed +
                                ") chemical order conc 1\nrule always aggregate order phi " + rule + "\n",
                            "charges.pex", ".");
}

const std::string point = "COLUMN == 60 and ROW == 60";
const std::string circle = "abs(hypot(COLUMN - 60, ROW - 60) - 25) < 0.5";
const std::string cross = "COLUMN == 60 or ROW == 60";

double taken(const Snapshot& state) {
    return static_cast<double>(std::ranges::count_if(state.conc[0], [](double order) { return order > 0.0; }));
}

// sum (1 - 1 / r) over all charges, in double, of every candidate.
double largest_error(const Snapshot& state) {
    const Front front(state, 0);
    double largest = 0.0;
    for (const std::uint32_t site : front.places()) {
        if (site == no_site) continue;
        const double potential = test::sum_over_charges(
            state, front, site, [&](std::uint32_t, double distance) { return 1.0 - 1.0 / distance; });
        largest = std::max(largest, std::abs(potential - state.conc[1][site]));
    }
    return largest;
}

void check_equal(const Experiment& experiment, std::uint64_t steps) {
    const auto reference = reference_backend(Precision::single_)->make_tissue(experiment);
    const auto device = opencl_backend()->make_tissue(experiment);
    const double seeds = taken(reference->read());
    for (const std::uint64_t some : {std::uint64_t{1}, std::uint64_t{2}, steps - 3}) {
        reference->advance(some);
        device->advance(some);
        INFO("after " << reference->iteration());
        REQUIRE(verify::differences(reference->read(), device->read()).empty());
    }
    CHECK(taken(device->read()) == seeds + static_cast<double>(steps));
}

}  // namespace

TEST_CASE("aggregates take the same sites on both backends") {
    const std::string eta = GENERATE("1", "3", "6", "10");
    for (const std::string& seed : {point, circle, cross}) {
        INFO(seed << ", eta " << eta);
        check_equal(charges("121 117", seed, "eta " + eta), 1000);
    }
}

TEST_CASE("parameters of an aggregate may follow the iteration, and a place draws it") {
    check_equal(charges("90 121 at 3 -4", "COLUMN == 45 and ROW == 60",
                        "eta (1 + ITERATION / 100) radius (2 + TIME / 50) towards (20 + ITERATION) 30 strength 3"),
                700);
}

TEST_CASE("every candidate's potential is the sum over all charges, within the bound that is stated") {
    const auto tissue = opencl_backend()->make_tissue(charges("300 300", "COLUMN == 150 and ROW == 150", "eta 3"));
    tissue->advance(5000);
    const Snapshot state = tissue->read();
    CHECK(largest_error(state) < 0x1p-22 * taken(state));
}

TEST_CASE("an aggregate goes on from what was kept, and grows until no free site is left") {
    const Experiment experiment = charges("20 11", "COLUMN == 5 and ROW == 5", "eta 2");
    for (const bool on_device : {false, true}) {
        const auto backend = on_device ? opencl_backend() : reference_backend(Precision::single_);
        const auto whole = backend->make_tissue(experiment);
        whole->advance(100);
        const Snapshot kept = whole->read();
        Snapshot rounded = kept;
        for (double& potential : rounded.conc[1]) potential = static_cast<float>(potential);
        whole->advance(80);
        for (const Snapshot& from : {kept, rounded}) {
            const auto part = backend->make_tissue(experiment, from);
            CHECK(verify::differences(part->read(), kept).empty());
            part->advance(80);
            CHECK(verify::differences(part->read(), whole->read()).empty());
        }
        whole->advance(1000);
        const Snapshot full = whole->read();
        CHECK(taken(full) == 220.0);
        CHECK(*std::ranges::max_element(full.birth) == 218);
    }
}

TEST_CASE("large eta leaves the middle, eta 0 fills it") {
    const auto reach = [](const std::string& eta) {
        const auto tissue = reference_backend(Precision::single_)->make_tissue(charges("121 121", point, "eta " + eta));
        tissue->advance(600);
        const Snapshot state = tissue->read();
        double farthest = 0.0;
        for (std::size_t site = 0; site < state.cells(); ++site) {
            if (state.conc[0][site] > 0.0) farthest = std::max(farthest, std::hypot(state.x[site], state.y[site]) / 2);
        }
        return farthest;
    };
    CHECK(reach("0") < 30.0);
    CHECK(reach("6") > 45.0);
}

TEST_CASE("a place that draws an aggregate has it grow there") {
    const auto tissue = reference_backend(Precision::single_)
                            ->make_tissue(charges("121 121", point, "eta 6 towards 100 0 strength 50"));
    tissue->advance(300);
    const Snapshot state = tissue->read();
    double sum = 0.0;
    for (std::size_t site = 0; site < state.cells(); ++site) sum += state.conc[0][site] > 0.0 ? state.x[site] : 0.0;
    CHECK(sum / 301.0 > 10.0);
}

TEST_CASE("an aggregate that cannot be is refused") {
    const auto refuse = [](const std::string& rule, const std::string& seed, const std::string& why) {
        CHECK_THROWS_WITH(reference_backend(Precision::single_)->make_tissue(charges("9 9", seed, rule))->advance(2),
                          Catch::Matchers::Contains(why));
    };
    refuse("eta 1", "1 == 2", "charges.pex: no site holds a charge");
    refuse("eta (1 - 2 * ITERATION)", "ROW == 4", "charges.pex:5: eta of 'aggregate' is -1 at iteration 1");
    refuse("radius 0", "ROW == 4", "radius of 'aggregate' is 0");
    refuse("towards 0 0 strength 1e9", "ROW == 4", "strength of 'aggregate' is 1e+09");
    refuse("radius 1e-6 towards 0 0 strength 1e6", "ROW == 4", "too much for this lattice");
    refuse("eta (X)", "ROW == 4", "the same for all sites");
}
