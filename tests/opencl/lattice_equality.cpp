// Lattice cases: the OpenCL device gives the bits of the reference. In float; in double and on every path they run in
// opencl_long/every_path.cpp, and what the table of pairs generates on all of them in every verification.
#include "lattice_run.hpp"

using namespace pelage;
using namespace pelage::verify;
using namespace test;

namespace {

OpenclOptions few_variants() {
    OpenclOptions made;
    made.variants = 4;  // so that the program that tests intervals itself runs too
    return made;
}

const OpenclOptions single = few_variants();

}  // namespace

TEST_CASE("float: diffusion with every stencil and boundary") { check_cases("diffusion/", single); }
TEST_CASE("float: every reaction") { check_cases("reaction/", single); }
TEST_CASE("float: polarized cells") { check_cases("rates/polarized", single); }
TEST_CASE("float: uneven rates") { check_cases("rates/uneven", single); }
TEST_CASE("float: rules") { check_cases("rules/", single); }
TEST_CASE("float: growth") { check_cases("growth/", single); }
