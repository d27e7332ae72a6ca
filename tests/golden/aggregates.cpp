// Laplacian growth as McConnell published it. Fed the draws of the golden sequences, the published arithmetic takes
// every one of their sites; exact sums take them, too, but for what its rounding explains.
#include "lattice_support.hpp"
#include "reference/aggregate/growth.hpp"
#include "reference/aggregate/published.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace pelage;

// The arrays have a row for each column of sites.
std::uint32_t site_of(double x, double y, std::size_t columns) {
    return static_cast<std::uint32_t>(static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x));
}

Snapshot seeded(const NpyArray& map) {
    Snapshot state;
    state.columns = map.shape[0];
    state.rows = map.shape[1];
    state.conc.assign(1, std::vector<double>(map.values.size(), 0.0));
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        const std::size_t x = i / state.rows, y = i % state.rows;
        state.conc[0][y * state.columns + x] = map.values[i];
    }
    return state;
}

bool kept(std::size_t step) {
    return step == 0 || step == 1 || step == 10 || step == 100 || step == 1000 || step == 10000;
}

struct Candidates {
    std::vector<std::uint32_t> sites;
    std::vector<double> potentials;
};

Candidates golden_candidates(const std::string& folder, std::size_t after, std::size_t columns) {
    const NpyArray sites = test::golden(folder + "cand" + std::to_string(after));
    Candidates found{{}, test::golden(folder + "phi" + std::to_string(after)).values};
    for (std::size_t i = 0; i + 1 < sites.values.size(); i += 2)
        found.sites.push_back(site_of(sites.values[i], sites.values[i + 1], columns));
    return found;
}

template <class Values>
Candidates candidates(const Front& front, const Values& potential_of) {
    Candidates found;
    for (std::size_t place = 0; place < front.places().size(); ++place) {
        if (front.places()[place] == no_site) continue;
        found.sites.push_back(front.places()[place]);
        found.potentials.push_back(potential_of(place));
    }
    return found;
}

void check_candidates(const std::string& folder, std::size_t after, float radius, const reference::Growth& growth) {
    const Candidates wanted = golden_candidates(folder, after, growth.front().columns());
    const auto count = static_cast<double>(growth.front().charges().size());
    const Candidates found = candidates(growth.front(), [&](std::size_t place) {
        return count - static_cast<double>(radius) * static_cast<double>(growth.sums()[place]) / inverse_parts;
    });
    INFO(folder << after);
    REQUIRE(found.sites == wanted.sites);
    double largest = 0.0;
    for (std::size_t i = 0; i < found.potentials.size(); ++i)
        largest = std::max(largest, std::abs(found.potentials[i] - wanted.potentials[i]));
    // The golden ones were added up in float: a rounding error of the size of the sum, at most, a charge.
    CHECK(largest <= count * std::ldexp(count + 8.0 * static_cast<double>(radius), -24));
}

// How far a draw lies beside the part of [0, 1) that a site has; 0: within.
double beside(double draw, std::uint32_t site, const reference::Growth& growth) {
    double total = 0.0, before = 0.0, own = 0.0;
    for (std::size_t place = 0; place < growth.weights().size(); ++place) {
        const auto weight = static_cast<double>(growth.weights()[place]);
        if (growth.front().places()[place] == site) {
            before = total;
            own = weight;
        }
        total += weight;
    }
    return std::max({0.0, before / total - draw, draw - (before + own) / total});
}

constexpr std::size_t steps = 3000;

// The published program adds potentials up in float: the more charges, the less its last bit is worth, and shares of
// the weights shift. So every golden site is taken, and what is checked is where its draw falls among our weights: on
// the very site while sums are short, and beside it by less than that rounding explains later.
void check_sequence(const std::string& name, float eta, float radius, std::size_t exact, double rounding) {
    const std::string folder = "laplacian_growth/" + name + "/";
    const NpyArray sites = test::golden(folder + "seq");
    const NpyArray draws = test::golden(folder + "u");
    reference::Growth growth(Front(seeded(test::golden(folder + "seed_map")), 0));
    Particle particle;
    particle.eta = eta;
    double farthest = 0.0;
    for (std::size_t step = 0; step < steps; ++step) {
        if (kept(step)) check_candidates(folder, step, radius, growth);
        const auto wanted = site_of(sites.values[2 * step], sites.values[2 * step + 1], growth.front().columns());
        particle.draw = static_cast<std::uint64_t>(draws.values[step] * 0x1p64);
        const auto site = growth.choose(particle);
        INFO(name << " at " << step);
        REQUIRE(site);
        if (step < exact) REQUIRE(*site == wanted);
        if (*site != wanted) farthest = std::max(farthest, beside(draws.values[step], wanted, growth));
        growth.take(wanted);
    }
    CHECK(farthest < rounding);
}

// To the bit: candidates, potentials and sites.
void check_published(const std::string& name, float eta, float radius) {
    const std::string folder = "laplacian_growth/" + name + "/";
    const NpyArray sites = test::golden(folder + "seq");
    const NpyArray draws = test::golden(folder + "u");
    reference::PublishedGrowth growth(Front(seeded(test::golden(folder + "seed_map")), 0), radius);
    for (std::size_t step = 0; step <= draws.values.size(); ++step) {
        INFO(name << " at " << step);
        if (kept(step)) {
            const Candidates wanted = golden_candidates(folder, step, growth.front().columns());
            const Candidates found = candidates(
                growth.front(), [&](std::size_t place) { return static_cast<double>(growth.potentials()[place]); });
            REQUIRE(found.sites == wanted.sites);
            REQUIRE(found.potentials == wanted.potentials);
        }
        if (step == draws.values.size()) break;
        const auto wanted = site_of(sites.values[2 * step], sites.values[2 * step + 1], growth.front().columns());
        REQUIRE(growth.choose(eta, static_cast<float>(draws.values[step])) == wanted);
        growth.take(wanted);
    }
}

}  // namespace

TEST_CASE("the published arithmetic takes every published site of lightning", "[golden][aggregate]") {
    if (test::shared_missing("golden/laplacian_growth")) return;
    check_published("lg_lightning", 6.8f, 4.0f);
}

TEST_CASE("the published arithmetic takes every published site of cracked stone", "[golden][aggregate]") {
    if (test::shared_missing("golden/laplacian_growth")) return;
    check_published("lg_cracked_stone", 10.0f, 2.0f);
}

TEST_CASE("lightning takes the published sites, up to their rounding", "[golden][aggregate]") {
    if (test::shared_missing("golden/laplacian_growth")) return;
    check_sequence("lg_lightning", 6.8f, 4.0f, 800, 1e-4);
}

TEST_CASE("cracked stone takes the published sites, up to their rounding", "[golden][aggregate]") {
    if (test::shared_missing("golden/laplacian_growth")) return;
    check_sequence("lg_cracked_stone", 10.0f, 2.0f, 1000, 1e-3);
}
