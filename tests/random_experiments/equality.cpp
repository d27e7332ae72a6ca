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

RandomLimits small(bool matrix, bool sqr_grid, bool free_cells) {
    RandomLimits limits;
    limits.cells = 150;
    limits.iterations = 30;
    limits.chemicals = 4;
    limits.rules = 6;
    limits.matrix = matrix;
    limits.sqr_grid = sqr_grid;
    limits.free_cells = free_cells;
    limits.phases = !free_cells;  // each is a program of its own there
    return limits;
}

}  // namespace

TEST_CASE("Random experiments on a matrix run alike on reference and device") {
    check_seeds(1000, 8, small(true, false, false));
}

TEST_CASE("Random experiments on a square grid run alike on reference and device") {
    check_seeds(2000, 5, small(false, true, false));
}

TEST_CASE("Random experiments of free cells run alike on reference and device") {
    check_seeds(3000, 4, small(false, false, true));
}
