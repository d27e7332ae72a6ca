// What the regular tests of free cells do with fewer features and fewer cells.
#include "opencl_cells/features_at_once.hpp"
#include "opencl_cells/many_cells.hpp"

#include <catch2/catch.hpp>

using pelage::Precision;

TEST_CASE("free cells: all features at once, in float and double, on each path") {
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    const bool together = GENERATE(false, true);
    CAPTURE(static_cast<int>(precision), together);

    test::check_features_at_once(precision, together, 0, 1);
}

TEST_CASE("two cells become 200,000 without a lost or a doubled cell") { test::check_growth_from_two(200'000); }
