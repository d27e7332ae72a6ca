// Every lattice case on every path: double, one cell a work-item, fused in bands, tiles.
#include "opencl/lattice_run.hpp"

using namespace pelage;
using namespace test;

namespace {

OpenclOptions path(const std::string& name) {
    OpenclOptions made;
    made.variants = 1;  // few programs: they take long to compile
    if (name == "double") made.precision = Precision::double_;
    if (name == "one cell a work-item") made.width = 1;
    if (name == "fused in bands" || name == "fused in bands, double") made.fusion = Fusion::always;
    if (name == "fused in bands, double") made.precision = Precision::double_;
    made.cut.columns = made.fusion == Fusion::always ? 32 : 0;
    if (name == "tiles") made.fusion = Fusion::tiled;
    if (name == "shared steps") made.fusion = Fusion::shared;
    return made;
}

}  // namespace

TEST_CASE("every lattice case gives the reference's bits on every path") {
    const std::string name = GENERATE(as<std::string>{}, "double", "one cell a work-item", "fused in bands",
                                      "fused in bands, double", "tiles", "shared steps");
    const std::string prefix =
        GENERATE(as<std::string>{}, "diffusion/", "reaction/", "rates/", "rules/", "growth/", "values/");
    INFO(name);

    check_cases(prefix, path(name));
}
