// Elementary functions on the device: the files they need, and the reference's bits.
#include "opencl/rules/functions.hpp"

#include "core/functions.hpp"
#include "support/form.hpp"
#include "support/opencl_session.hpp"
#include "verify/check.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace pelage;

namespace {

std::size_t place_of(const std::vector<std::string>& files, const std::string& file) {
    return static_cast<std::size_t>(std::ranges::find(files, file) - files.begin());
}

}  // namespace

TEST_CASE("a function's file comes after those that it needs, each once") {
    CHECK(function_files({}).empty());
    CHECK(function_files({*function_named("min")}) ==
          std::vector<std::string>{"functions/numbers.cl", "functions/min.cl"});
    const std::vector<std::string> files = function_files({*function_named("abs"), *function_named("exp")});
    CHECK(files.size() == 4);
    CHECK(place_of(files, "functions/numbers.cl") < place_of(files, "functions/power.cl"));
    CHECK(place_of(files, "functions/power.cl") < place_of(files, "functions/exp.cl"));
    CHECK(place_of(files, "functions/abs.cl") < files.size());
}

TEST_CASE("functions have the reference's bits on the device, in both precisions") {
    verify::Place place(test::session().info(), 1, test::long_form(), true);
    for (const verify::Check& check : verify::function_checks()) {
        const verify::Outcome outcome = verify::carry_out(check, place);
        INFO(check.name << ": " << outcome.message << outcome.tally.first);
        CHECK(outcome.verdict == verify::Verdict::passed);
        CHECK(outcome.tally.cells_compared >= 64);
    }
}
