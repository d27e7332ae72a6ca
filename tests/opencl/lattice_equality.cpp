// Lattice cases: the OpenCL device gives the bits of the reference. In float all cases; on the other paths a share of
// them, and all in opencl_long/every_path.cpp.
#include "lattice_run.hpp"

using namespace pelage;
using namespace pelage::verify;
using namespace test;

namespace {

OpenclOptions options(Precision precision, std::size_t variants, std::size_t width = 0) {
    OpenclOptions made;
    made.precision = precision;
    made.variants = variants;  // few, so that the program that tests intervals itself runs too
    made.width = width;
    return made;
}

const OpenclOptions single = options(Precision::single_, 4);
const OpenclOptions twice = options(Precision::double_, 1);
const OpenclOptions narrow = options(Precision::single_, 0, 1);  // one cell a work-item, as on a GPU

}  // namespace

TEST_CASE("float: diffusion with every stencil and boundary") { check_cases("diffusion/", single); }
TEST_CASE("float: every reaction") { check_cases("reaction/", single); }
TEST_CASE("float: polarized cells") { check_cases("rates/polarized", single); }
TEST_CASE("float: uneven rates") { check_cases("rates/uneven", single); }
TEST_CASE("float: rules") { check_cases("rules/", single); }
TEST_CASE("float: growth") { check_cases("growth/", single); }

TEST_CASE("double: diffusion") { check_cases("diffusion/", twice, {0, 3}); }
TEST_CASE("double: every reaction") { check_cases("reaction/", twice, {0, 2}); }
TEST_CASE("double: rates") { check_cases("rates/uneven", twice); }
TEST_CASE("double: polarized cells") { check_cases("rates/polarized/published", twice); }
TEST_CASE("double: rules") { check_cases("rules/", twice, {0, 3}); }
TEST_CASE("double: growth") { check_cases("growth/", twice, {0, 3}); }

TEST_CASE("one cell a work-item: diffusion") {
    check_cases("diffusion/nine-point", narrow);
    check_cases("diffusion/five-point/no-flux", narrow);
    check_cases("diffusion/published", narrow);
}
TEST_CASE("one cell a work-item: reactions and rates") {
    check_cases("reaction/", narrow, {1, 2});
    check_cases("rates/polarized/sims", narrow);
    check_cases("rates/polarized/published", narrow);
    check_cases("rates/uneven/nine-point/no-flux", narrow);
}
TEST_CASE("one cell a work-item: rules") { check_cases("rules/", narrow, {1, 3}); }
TEST_CASE("one cell a work-item: growth") { check_cases("growth/", narrow, {1, 3}); }
