// Comparisons of whole numbers in kernels: every path carries them out exactly where float and int no longer can.
#include "lattice_run.hpp"

#include <tuple>
#include <utility>

using namespace pelage;
using namespace test;

TEST_CASE("whole numbers near the last iteration: plain, shared, streamed and tiled kernels, float and double") {
    OpenclOptions options;
    options.variants = 1;
    using Way = std::pair<Path, Precision>;
    std::tie(options.path, options.precision) =
        GENERATE(Way{Path::step, Precision::double_}, Way{Path::shared, Precision::single_},
                 Way{Path::streamed, Precision::single_}, Way{Path::tiled, Precision::double_});
    CAPTURE(static_cast<int>(options.path), static_cast<int>(options.precision));

    const bool fused = options.path == Path::step || options.path == Path::streamed;  // each in one: they take long
    check_cases(fused ? "rules/whole-numbers/fused" : "rules/whole-numbers/published", options);
}
