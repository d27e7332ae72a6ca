// Comparisons of whole numbers in kernels: every path carries them out exactly where float and int no longer can.
#include "lattice_run.hpp"

#include <tuple>
#include <utility>

using namespace pelage;
using namespace test;

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
