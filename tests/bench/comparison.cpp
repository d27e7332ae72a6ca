// The comparison before anything is timed, the ratios, and the guard over them.
#include "bench/cases.hpp"
#include "bench/guard.hpp"
#include "bench/options.hpp"
#include "bench/report.hpp"
#include "bench/task.hpp"
#include "core/error.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <vector>

using namespace pelage;
using Catch::Contains;

namespace {

bench::Outcome outcome(const std::vector<double>& values) { return {bench::float_array("chemical 0", values)}; }

bench::Result result(const std::string& backend, double updates_per_second) {
    bench::Result one;
    one.suite = "lattice";
    one.name = "turing";
    one.size = 100;
    one.backend = backend;
    one.device = backend.rfind("opencl", 0) == 0 ? "device" : "host";
    one.seconds = one.best = 1;
    one.updates_per_second = updates_per_second;
    one.bandwidth_share = 2;
    return one;
}

}  // namespace

TEST_CASE("the comparison sees one wrong bit, a wrong sign of zero, a missing element and what is not finite") {
    const bench::Outcome initial = outcome({1, 2, 0});
    const bench::Outcome expected = outcome({1.5, 2.5, 0});
    const double nan = std::numeric_limits<double>::quiet_NaN();

    CHECK(bench::disagreement(initial, expected, expected) == "");
    CHECK_THAT(bench::disagreement(initial, expected, outcome({1.5, 2.5000002, 0})),
               Contains("differs in 1 of 3 places, first at 1"));
    CHECK_THAT(bench::disagreement(initial, expected, outcome({1.5, 2.5, -0.0})), Contains("first at 2"));
    CHECK_THAT(bench::disagreement(initial, expected, outcome({1.5, 2.5})), Contains("2 entries instead of 3"));
    CHECK_THAT(bench::disagreement(initial, expected, {}), Contains("0 arrays instead of 1"));
    CHECK_THAT(bench::disagreement(initial, outcome({1.5, nan, 0}), outcome({1.5, nan, 0})), Contains("not finite"));
    CHECK_THAT(bench::disagreement(initial, initial, initial), Contains("nothing changed"));
}

TEST_CASE("ratios hold opencl against every other backend of the case and against a copy") {
    bench::Report report;
    report.results = {result("reference", 10), result("openmp", 100), result("opencl", 300)};
    report.results.push_back(result("openmp", 1));
    report.results.back().size = 101;

    const auto ratios = bench::ratios(report);

    REQUIRE(ratios.size() == 3);
    CHECK(ratios[0].against == "reference");
    CHECK(ratios[0].ratio == Approx(30));
    CHECK(ratios[1].against == "openmp");
    CHECK(ratios[1].ratio == Approx(3));
    CHECK(ratios[2].against == "copy");
    CHECK(ratios[2].ratio == Approx(2));
}

TEST_CASE("the guard keeps ratios within its slack, loses others, and misses what was not measured") {
    bench::Report report;
    report.results = {result("openmp", 100), result("opencl", 300)};
    const auto ratios = bench::ratios(report);
    const auto verdict_on = [&](std::size_t size, double ratio) {
        return bench::judge({0.5, {{"lattice", "turing", size, "openmp", ratio}}}, ratios);
    };

    CHECK(verdict_on(100, 5.9).kept);
    CHECK_THAT(verdict_on(100, 5.9).text, Contains("kept") && Contains("3.00") && Contains("2.95"));
    CHECK_FALSE(verdict_on(100, 6.1).kept);
    CHECK_THAT(verdict_on(100, 6.1).text, Contains("LOST"));
    CHECK_FALSE(verdict_on(99, 0.1).kept);
    CHECK_THAT(verdict_on(99, 0.1).text, Contains("not measured"));
}

TEST_CASE("the guard measures only what it asks about") {
    const bench::Guard guard{0.5,
                             {{"lattice", "turing", 100, "openmp", 2},
                              {"lattice", "turing", 256, "copy", 2},
                              {"neighbours", "hexagonal", 600, "nanoflann", 2}}};

    const auto options = bench::options_for(guard, {});

    REQUIRE(options.size() == 2);
    CHECK(options[0].suite == "lattice");
    CHECK(options[0].cases == std::vector<std::string>{"turing"});
    CHECK(options[0].sizes == std::vector<std::size_t>{100, 256});
    CHECK(options[0].wants("openmp"));
    CHECK_FALSE(options[0].wants("reference"));
    CHECK(options[1].wants("nanoflann"));
}

TEST_CASE("the committed table of ratios can be read and names cases that exist") {
    const bench::Guard guard = bench::read_guard(PELAGE_SOURCE "/bench/ratios.json");

    CHECK(guard.demands.size() >= 5);
    for (const bench::Options& options : bench::options_for(guard, {})) {
        CHECK_NOTHROW(bench::check(options));
        CHECK(bench::chosen_cases(options).size() == 1);
    }
}
