// What is foretold of a run is what comes.
#include "core/forecast.hpp"

#include "core/schedule.hpp"
#include "language/parse.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

namespace {

Experiment parsed(const std::string& rules) {
    return parse_experiment("define chemical U\nuse chemical U conc 1 diff 0.1\ncreate matrix 10 6\n" + rules,
                            "forecast.pex", ".");
}

}  // namespace

TEST_CASE("forecast: cells after expansions") {
    const Experiment still = parsed("rule always change U conc 0.1\n");
    const Experiment growing = parsed("rule from 10 until 49 every 10 always expand rows 1 columns 2\n");

    CHECK(final_cells(still, 1000) == 60);
    CHECK(final_cells(growing, 10) == 60);
    CHECK(final_cells(growing, 11) == 12 * 7);
    CHECK(final_cells(growing, 1000) == 18 * 10);
    CHECK(final_size(growing, 1000)->columns == 18);
    CHECK(final_size(growing, 1000)->rows == 10);
}

TEST_CASE("forecast: a set of rules ends where one of them ends or another begins for good") {
    const Experiment experiment = parsed(
        "rule until 99 always change U conc 0.1\n"
        "rule from 50 always change U conc -0.1\n"
        "rule every 7 always change U conc 0.2\n"
        "rule from 3 always expand rows 1 columns 1\n");

    CHECK(end_of_set(experiment, active_rules(experiment, 0), 0) == 50);
    CHECK(end_of_set(experiment, active_rules(experiment, 50), 50) == 100);
    CHECK(end_of_set(experiment, active_rules(experiment, 60), 60) == 100);
    CHECK(end_of_set(experiment, active_rules(experiment, 100), 100) == forever);
}
