// Every lattice case: the OpenCL device gives the bits of the reference.
#include "lattice_run.hpp"

using namespace pelage;
using namespace test;

namespace {

OpenclOptions options(Precision precision, std::size_t width = 0) {
    OpenclOptions made;
    made.precision = precision;
    made.width = width;
    return made;
}

}  // namespace

TEST_CASE("float: diffusion with every stencil and boundary") {
    check_cases("diffusion/nine-point", options(Precision::single_));
    check_cases("diffusion/moore", options(Precision::single_));
}
TEST_CASE("float: diffusion with every stencil and boundary, continued") {
    check_cases("diffusion/five-point", options(Precision::single_));
    check_cases("diffusion/sims", options(Precision::single_));
    check_cases("diffusion/published", options(Precision::single_));
}
TEST_CASE("float: every reaction") { check_cases("reaction/", options(Precision::single_)); }
TEST_CASE("float: uneven rates") { check_cases("rates/uneven", options(Precision::single_)); }
TEST_CASE("float: polarized cells") { check_cases("rates/polarized", options(Precision::single_)); }
TEST_CASE("float: rules") { check_cases("rules/", options(Precision::single_)); }
TEST_CASE("float: growth") { check_cases("growth/", options(Precision::single_)); }

TEST_CASE("double: diffusion") { check_cases("diffusion/", options(Precision::double_)); }
TEST_CASE("double: every reaction") { check_cases("reaction/", options(Precision::double_)); }
TEST_CASE("double: uneven rates") { check_cases("rates/", options(Precision::double_)); }
TEST_CASE("double: rules and growth") {
    check_cases("rules/", options(Precision::double_));
    check_cases("growth/", options(Precision::double_));
}

TEST_CASE("one cell a work-item, as on a GPU: diffusion") { check_cases("diffusion/", options(Precision::single_, 1)); }
TEST_CASE("one cell a work-item, as on a GPU: rates") { check_cases("rates/", options(Precision::single_, 1)); }
TEST_CASE("one cell a work-item, as on a GPU: rules and growth") {
    check_cases("reaction/", options(Precision::single_, 1));
    check_cases("rules/", options(Precision::single_, 1));
    check_cases("growth/", options(Precision::single_, 1));
}
