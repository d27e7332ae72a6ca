// What a report says of the likely cause: kernels that failed before those that use them.
#include "verify/causes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace pelage::verify;

namespace {

Result of_kernel(const std::string& kernel, Verdict verdict) {
    Result made;
    made.name = kernel + "/case";
    made.kernel = kernel;
    made.verdict = verdict;
    return made;
}

}  // namespace

TEST_CASE("every kernel of a check has its place, after all that it uses") {
    std::set<std::string_view> known;
    for (const Dependence& one : dependences()) {
        CAPTURE(one.kernel);
        for (const std::string_view used : one.uses) CHECK(known.contains(used));
        CHECK(known.insert(one.kernel).second);
    }
    std::set<std::string> checked;
    for (const Check& check : all_checks(1)) {
        CAPTURE(check.kernel);
        CHECK(known.contains(check.kernel));
        checked.insert(check.kernel);
    }
    CHECK(checked.size() == known.size());
}

TEST_CASE("what failed and uses nothing that failed is likely at fault, and stands first") {
    const std::vector<Result> results{of_kernel("random experiments", Verdict::failed),
                                      of_kernel("diffusion", Verdict::passed),
                                      of_kernel("division", Verdict::failed),
                                      of_kernel("sort", Verdict::failed),
                                      of_kernel("neighbour search", Verdict::passed),
                                      of_kernel("scan", Verdict::passed),
                                      of_kernel("laws", Verdict::mistrusted)};

    CHECK(likely_roots(results) == std::vector<std::string>{"sort", "laws"});
    const std::vector<Result> found = failures(results);
    REQUIRE(found.size() == 4);
    CHECK(found[0].kernel == "sort");
    CHECK(found[1].kernel == "laws");
    CHECK(found[2].kernel == "division");
    CHECK(found[3].kernel == "random experiments");
    CHECK(causes_text(results) ==
          "likely at fault: sort, laws; what uses them fails, too: division, random experiments");
}

TEST_CASE("where nothing failed nothing is at fault") {
    const std::vector<Result> results{of_kernel("sort", Verdict::passed), of_kernel("scan", Verdict::skipped)};
    CHECK(likely_roots(results).empty());
    CHECK(failures(results).empty());
    CHECK(causes_text(results).empty());
}
