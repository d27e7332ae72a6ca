// Every lattice case on every path: double, one cell a work-item, streamed in bands, tiled.
#include "opencl/lattice_run.hpp"

using namespace pelage;
using namespace test;

namespace {

OpenclOptions path(const std::string& name) {
    OpenclOptions made;
    made.variants = 1;  // few programs: they take long to compile
    if (name == "double") made.precision = Precision::double_;
    if (name == "one cell a work-item") made.width = 1;
    if (name == "streamed in bands" || name == "streamed in bands, double") made.path = Path::streamed;
    if (name == "streamed in bands, double") made.precision = Precision::double_;
    made.cut.columns = made.path == Path::streamed ? 32 : 0;
    if (name == "tiled") made.path = Path::tiled;
    if (name == "shared") made.path = Path::shared;
    return made;
}

}  // namespace

TEST_CASE("every lattice case gives the reference's bits on every path") {
    const std::string name = GENERATE(as<std::string>{}, "double", "one cell a work-item", "streamed in bands",
                                      "streamed in bands, double", "tiled", "shared");
    const std::string prefix =
        GENERATE(as<std::string>{}, "diffusion/", "reaction/", "rates/", "rules/", "growth/", "values/");
    INFO(name);

    check_cases(prefix, path(name));
}
