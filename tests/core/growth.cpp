// The distributions of expansion picks, by chi-square against their definitions.
#include "core/growth.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace pelage;

namespace {

constexpr std::size_t places = 60;
constexpr std::size_t lines = 200;

std::vector<double> histogram(const Expand& growth, bool column, std::size_t insertions) {
    std::vector<double> counts(places, 0.0);
    for (std::size_t iteration = 0; iteration < insertions; ++iteration) {
        const Insertion insertion =
            draw_insertion(growth, column, column ? places : lines, column ? lines : places, 11, iteration, 2, 0);
        REQUIRE(insertion.picks.size() == lines);
        for (const std::uint32_t pick : insertion.picks) {
            REQUIRE(pick < places);
            counts[pick] += 1;
        }
    }
    return counts;
}

double chi_square(const std::vector<double>& counts, std::vector<double> weights) {
    const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    double chi2 = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = weights[i] / sum * total;
        REQUIRE(expected > 5.0);
        chi2 += (counts[i] - expected) * (counts[i] - expected) / expected;
    }
    return chi2;
}

constexpr double chi_square_limit = 98.3;  // 59 degrees of freedom, p = 0.001

}  // namespace

TEST_CASE("uniform picks are uniform") {
    const Expand growth;

    const std::vector<double> counts = histogram(growth, true, 500);

    CHECK(chi_square(counts, std::vector<double>(places, 1.0)) < chi_square_limit);
}

TEST_CASE("triangular picks rise to the middle and fall") {
    Expand growth;
    growth.distribution = Distribution::triangular;
    std::vector<double> weights;
    for (std::size_t p = 0; p < places; ++p) weights.push_back(static_cast<double>(std::min(p + 1, places - p)));

    const std::vector<double> counts = histogram(growth, false, 500);

    CHECK(chi_square(counts, weights) < chi_square_limit);
    CHECK(chi_square(counts, std::vector<double>(places, 1.0)) > 10 * chi_square_limit);
}

TEST_CASE("normal picks have a deviation of a sixth of the length, clipped") {
    Expand growth;
    growth.distribution = Distribution::normal;

    const std::vector<double> counts = histogram(growth, true, 500);

    double total = 0.0, mean = 0.0, variance = 0.0;
    for (std::size_t p = 0; p < places; ++p) total += counts[p], mean += counts[p] * (static_cast<double>(p) + 0.5);
    mean /= total;
    for (std::size_t p = 0; p < places; ++p) {
        const double d = static_cast<double>(p) + 0.5 - mean;
        variance += counts[p] / total * d * d;
    }
    CHECK(std::abs(mean - places / 2.0) < 5 * (places / 6.0) / std::sqrt(total));
    CHECK(std::abs(std::sqrt(variance) - places / 6.0) < 0.15);  // clipping and binning move it by 0.02
}

TEST_CASE("shuffled picks use every place equally often") {
    Expand growth;
    growth.distribution = Distribution::shuffled;

    const Insertion once = draw_insertion(growth, true, places, places, 1, 0, 0, 0);
    const Insertion again = draw_insertion(growth, true, places, places, 1, 0, 0, 1);

    std::vector<std::uint32_t> sorted = once.picks;
    std::sort(sorted.begin(), sorted.end());
    for (std::uint32_t p = 0; p < places; ++p) CHECK(sorted[p] == p);
    CHECK(once.picks != sorted);
    CHECK(once.picks != again.picks);
}

TEST_CASE("a band of rows is picked by its weight, and only for row insertion") {
    Expand growth;
    growth.band_weight = 0.5;
    growth.band_low = 0.45;
    growth.band_high = 0.55;
    std::vector<double> weights(places, 1.0);
    for (std::size_t p = 0; p < places; ++p) {
        const double at = static_cast<double>(p) / places;
        if (at >= 0.45 && at <= 0.55) weights[p] = 0.5;
    }

    CHECK(chi_square(histogram(growth, false, 2000), weights) < chi_square_limit);
    CHECK(chi_square(histogram(growth, false, 2000), std::vector<double>(places, 1.0)) > chi_square_limit);
    CHECK(chi_square(histogram(growth, true, 2000), std::vector<double>(places, 1.0)) < chi_square_limit);
}
