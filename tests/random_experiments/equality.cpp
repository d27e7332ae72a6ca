// Experiments drawn from the whole language end in the same bits on the reference and on the device.
#include "support/random_runs.hpp"

#include <catch2/catch.hpp>

using namespace pelage::verify;

namespace {

void check_seeds(std::uint64_t first, std::uint64_t count, const RandomLimits& limits) {
    constexpr std::size_t variations = 3;
    test::RandomRuns runs(true);

    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::string difference = runs.check(seed, limits, variations);
        INFO(difference);
        REQUIRE(difference.empty());
    }

    CHECK(runs.runs() == count * (1 + variations));
    CHECK(2 * runs.finite() > runs.runs());
}

// Of one kind of tissue.
RandomLimits small(bool RandomLimits::*kind) {
    RandomLimits limits;
    for (bool RandomLimits::*other : {&RandomLimits::matrix, &RandomLimits::sqr_grid, &RandomLimits::free_cells,
                                      &RandomLimits::volume, &RandomLimits::mesh, &RandomLimits::charges})
        limits.*other = other == kind;
    limits.cells = 150;
    limits.iterations = 30;
    limits.chemicals = 4;
    limits.rules = 6;
    limits.phases = !limits.free_cells;  // each is a program of its own there
    return limits;
}

}  // namespace

TEST_CASE("Random experiments on a matrix run alike on reference and device") {
    check_seeds(1000, 8, small(&RandomLimits::matrix));
}

TEST_CASE("Random experiments on a square grid run alike on reference and device") {
    check_seeds(2000, 5, small(&RandomLimits::sqr_grid));
}

TEST_CASE("Random experiments of free cells run alike on reference and device") {
    check_seeds(3000, 4, small(&RandomLimits::free_cells));
}

TEST_CASE("Random experiments in volumes run alike on reference and device") {
    check_seeds(4000, 6, small(&RandomLimits::volume));
}

TEST_CASE("Random experiments on meshes run alike on reference and device") {
    check_seeds(5000, 6, small(&RandomLimits::mesh));
}

TEST_CASE("Random experiments with charges run alike on reference and device") {
    check_seeds(6000, 12, small(&RandomLimits::charges));
}
