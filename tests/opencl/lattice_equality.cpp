// Lattice cases: the OpenCL device gives the bits of the reference. In float; in double and on every path they run in
// opencl_long/every_path.cpp, and what the table of pairs generates on all of them in every verification.
#include "lattice_run.hpp"

using namespace pelage;
using namespace pelage::verify;
using namespace test;

namespace {

OpenclOptions few_variants() {
    OpenclOptions made;
    made.variants = test::long_form() ? 4 : 1;  // so that the program that tests intervals itself runs too
    return made;
}

void check(const char* names) { check_cases(names, few_variants()); }

}  // namespace

TEST_CASE("float: diffusion with every stencil and boundary") { check("diffusion/"); }
TEST_CASE("float: every reaction") { check("reaction/"); }
TEST_CASE("float: polarized cells") { check("rates/polarized"); }
TEST_CASE("float: uneven rates") { check("rates/uneven"); }
TEST_CASE("float: rules") { check("rules/"); }
TEST_CASE("float: growth") { check("growth/"); }
