// Aggregates with a far field: the bound of the potentials over whole runs, the same sites on both backends, and from a
// state that was kept.
#include "aggregate/direct_sum.hpp"
#include "core/aggregate.hpp"
#include "core/far_grid.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/aggregate/device.hpp"
#include "opencl/aggregate/far_device.hpp"
#include "opencl/backend.hpp"
#include "reference/aggregate/far_growth.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

using namespace pelage;

namespace {

Experiment far_charges(const std::string& size, const std::string& seed, const std::string& rule) {
    return parse_experiment(
        "define chemical order\ndefine chemical phi\ndefine chemical family\ndefine chemical mass\n"
        "use seed 3\ncreate charges " +
            size + "\nset cells where (" + seed + ") chemical order conc 1\nrule always aggregate order phi " + rule +
            " far-field\n",
        "far.pex", ".");
}

// The largest part of a sum of size / r over all charges that its candidate's potential is off by.
double largest_part_off(const Snapshot& state, bool sized) {
    const Front front(state, 0);
    double largest = 0.0;
    for (const std::uint32_t site : front.places()) {
        if (site == no_site) continue;
        const double sum = test::sum_over_charges(state, front, site, [&](std::uint32_t charge, double distance) {
            return (sized ? state.conc[3][charge] : 1.0) / distance;
        });
        const double told = static_cast<double>(front.charges().size()) - state.conc[1][site];
        largest = std::max(largest, std::abs(told / sum - 1.0));
    }
    return largest;
}

}  // namespace

TEST_CASE("aggregates with a far field take the same sites on both backends, in one go and from what was kept") {
    for (const char* rule : {"eta 3", "eta 0", "eta (1 + mod(ITERATION, 40) / 7) size mass (0.01 + 9 * RANDOM ^ 4)"}) {
        const Experiment experiment = far_charges("150 120", "COLUMN == 75 and ROW == 60 or RANDOM < 0.0003", rule);
        INFO(rule);
        const auto reference = reference_backend(Precision::single_)->make_tissue(experiment);
        std::vector<std::unique_ptr<Tissue>> found;
        found.push_back(opencl_backend()->make_tissue(experiment));
        for (const std::uint64_t some : {1u, 2u, 60u, 137u}) {
            reference->advance(some);
            const Snapshot state = reference->read();
            for (const auto& tissue : found) {
                tissue->advance(some);
                INFO("after " << state.iteration);
                REQUIRE(verify::differences(state, tissue->read()).empty());
            }
        }
        const Snapshot kept = reference->read();
        reference->advance(70);
        found.push_back(reference_backend(Precision::single_)->make_tissue(experiment, kept));
        for (const auto& tissue : found) {
            tissue->write(kept);
            REQUIRE(verify::differences(kept, tissue->read()).empty());
            tissue->advance(70);
            REQUIRE(verify::differences(reference->read(), tissue->read()).empty());
        }
    }
}

TEST_CASE("with a far field a lattice fills up, although the last candidates are all alike") {
    const Experiment experiment = far_charges("40 11", "COLUMN == 5 and ROW == 5", "eta 2");
    for (const bool on_device : {false, true}) {
        const auto tissue =
            (on_device ? opencl_backend() : reference_backend(Precision::single_))->make_tissue(experiment);
        tissue->advance(1000);
        const Snapshot full = tissue->read();
        CHECK(*std::ranges::max_element(full.conc[0]) == 440.0);
        CHECK(*std::ranges::max_element(full.birth) == 438);
    }
}

TEST_CASE("with a far field each candidate is chosen as often as its weight says") {
    const auto tissue =
        reference_backend(Precision::single_)->make_tissue(far_charges("60 60", "COLUMN == 30 and ROW == 30", "eta 3"));
    tissue->advance(85);
    const reference::FarGrowth growth(Front(tissue->read(), 0));
    const std::vector<std::int64_t> sums = growth.sums();
    std::int64_t lowest = std::numeric_limits<std::int64_t>::max(), highest = 0;
    for (std::size_t place = 0; place < sums.size(); ++place) {
        if (growth.front().places()[place] == no_site) continue;
        lowest = std::min(lowest, sums[place]);
        highest = std::max(highest, sums[place]);
    }
    constexpr std::uint64_t draws = 4'000;
    for (const float eta : {0.5f, 3.0f, 6.8f}) {
        std::vector<double> weights(sums.size(), 0.0), counts(sums.size(), 0.0);
        double total = 0.0, off = 0.0, kinds = 0.0;
        for (std::size_t place = 0; place < sums.size(); ++place) {
            if (growth.front().places()[place] == no_site) continue;
            const double share = static_cast<double>(highest - sums[place]) / static_cast<double>(highest - lowest);
            total += weights[place] = std::pow(share, static_cast<double>(eta));
        }
        Particle particle;
        particle.eta = eta;
        for (particle.iteration = 1; particle.iteration <= draws; ++particle.iteration) {
            const auto site = growth.choose(particle);
            REQUIRE(site);
            ++counts[static_cast<std::size_t>(growth.front().sites()[*site])];
        }
        for (std::size_t place = 0; place < sums.size(); ++place) {
            const double expected = weights[place] / total * static_cast<double>(draws);
            if (expected < 5.0) continue;
            off += (counts[place] - expected) * (counts[place] - expected) / expected;
            ++kinds;
        }
        INFO("eta " << eta << ", " << kinds << " candidates, chi square " << off);
        CHECK(kinds > 8.0);
        CHECK(std::abs(off - kinds) < 5.0 * std::sqrt(2.0 * kinds));  // five standard deviations
    }
}

TEST_CASE("a candidate takes less than 64 bytes on a device, with and without a far field") {
    constexpr std::size_t side = 1200;
    Snapshot start;
    start.columns = start.rows = side;
    start.conc.emplace_back(side * side);
    start.conc[0][side / 2 * side + side / 2] = 1.0;
    const auto session = std::make_shared<const Session>(select_device(), OpenclOptions{});
    for (const bool far : {false, true}) {
        Front front(start, 0);
        std::unique_ptr<Grower> grower = std::make_unique<DeviceAggregate>(session, false);
        if (far) grower = std::make_unique<DeviceFarAggregate>(session, false, far_grid(side, side));
        grower->upload(front, {});
        Particle particle;
        particle.eta = 3.0f;
        while (front.charges().size() < 12'000) {
            std::vector<Particle> asked;
            while (asked.size() < grower->particles_at_once(front)) {
                ++particle.iteration;
                particle.draw = further_draw(particle, 0);
                asked.push_back(particle);
            }
            for (const std::uint32_t site : grower->grow(front, asked)) front.take(site);
        }
        const std::size_t candidates = front.places().size() - front.left().size();
        INFO(candidates << " candidates in " << grower->candidate_bytes() << " bytes");
        CHECK(candidates > 5000);
        CHECK(grower->candidate_bytes() >= 16 * candidates);
        CHECK(grower->candidate_bytes() < 64 * candidates);
    }
}

TEST_CASE("with a far field every candidate's potential is within its bound over a whole run") {
    for (const bool sized : {false, true}) {
        const auto tissue = opencl_backend()->make_tissue(far_charges(
            "250 200", "COLUMN == 125 and ROW == 100", sized ? "eta 3 size mass (0.01 + 9 * RANDOM ^ 4)" : "eta 3"));
        double largest = 0.0;
        for (int part = 0; part < 12; ++part) {
            tissue->advance(250);
            const double off = largest_part_off(tissue->read(), sized);
            CHECK(off < far_bound);
            largest = std::max(largest, off);
        }
        CHECK(largest > 1e-7);  // there is something to be near to
    }
}
