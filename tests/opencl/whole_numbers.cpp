// Comparisons of whole numbers in kernels: every path carries them out exactly where float and int no longer can.
#include "lattice_run.hpp"
#include "opencl/emit_whole.hpp"

#include <tuple>
#include <utility>

using namespace pelage;
using namespace test;

TEST_CASE("a comparison of a whole number with any number becomes one of whole numbers, or a constant") {
    const auto text = [](Comparison comparison, double number) { return emit_whole_test("n", comparison, number); };

    CHECK(text(Comparison::equal, 16777217) == "TO_MASK(n == W(16777217u))");
    CHECK(text(Comparison::equal, 0.5) == "ALL_FALSE");
    CHECK(text(Comparison::not_equal, -1) == "ALL_TRUE");
    CHECK(text(Comparison::equal, 4294967296.0) == "ALL_FALSE");
    CHECK(text(Comparison::less, 2.5) == "TO_MASK(n < W(3u))");
    CHECK(text(Comparison::less, 0) == "ALL_FALSE");
    CHECK(text(Comparison::less, 1e30) == "ALL_TRUE");
    CHECK(text(Comparison::less_equal, 2.5) == "TO_MASK(n <= W(2u))");
    CHECK(text(Comparison::less_equal, -0.5) == "ALL_FALSE");
    CHECK(text(Comparison::less_equal, 4294967295.0) == "ALL_TRUE");
    CHECK(text(Comparison::greater, 2.5) == "TO_MASK(n > W(2u))");
    CHECK(text(Comparison::greater, -0.5) == "ALL_TRUE");
    CHECK(text(Comparison::greater, 4294967295.0) == "ALL_FALSE");
    CHECK(text(Comparison::greater_equal, 2.5) == "TO_MASK(n >= W(3u))");
    CHECK(text(Comparison::greater_equal, -3) == "ALL_TRUE");
    CHECK(text(Comparison::greater_equal, 4294967295.5) == "ALL_FALSE");
}

TEST_CASE("whole numbers near the last iteration: plain, shared, streamed and tiled kernels, float and double") {
    OpenclOptions options;
    options.variants = 1;
    using Way = std::pair<Fusion, Precision>;
    std::tie(options.fusion, options.precision) =
        GENERATE(Way{Fusion::never, Precision::double_}, Way{Fusion::shared, Precision::single_},
                 Way{Fusion::always, Precision::single_}, Way{Fusion::tiled, Precision::double_});
    CAPTURE(static_cast<int>(options.fusion), static_cast<int>(options.precision));

    check_cases("rules/whole-numbers/fused", options);
    check_cases("rules/whole-numbers/published", options);
}
