// Every rule and property of free cells on the device against the reference, bit for bit, in float and double.
#include "features_at_once.hpp"

#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "reference/cells/tissue.hpp"
#include "support/free_cells.hpp"
#include "verify/cases_cells.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace pelage;

TEST_CASE("free cells: each feature on the device equals the reference") {
    // Half of them one by one, in one of two forms; they take long to compile. All together: see below.
    const auto& feature =
        GENERATE(filter([](const auto& one) { return one.name.size() % 4 < 2; }, from_range(verify::cell_cases())));
    CellsOptions options;
    options.together = feature.name.size() % 2 == 0;
    CAPTURE(feature.name, *options.together);
    const auto experiment = test::experiment(feature.text());

    const auto expected = test::on_reference(experiment);
    const auto found = test::on_device(experiment, options);

    test::check_equal_runs(*expected, *found, 40, 8);
}

TEST_CASE("free cells: half of the features at once in float, the others in double") {
    SECTION("float, one iteration a launch") { test::check_features_at_once(Precision::single_, false, 0, 2); }
    SECTION("double, many iterations a launch") { test::check_features_at_once(Precision::double_, true, 1, 2); }
}

TEST_CASE("free cells: experiments without a polarity, a chemical or a neighbour") {
    const std::string lines =
        GENERATE(as<std::string>{},
                 "define chemical A\nuse chemical A conc 3 diff 0.1\ncreate cell 0 0\n"
                 "rule always change A conc 1\n",
                 "define chemical A\nuse chemical A conc 3 dev 1\ncreate cell 0 0\ncreate cell 1 0\n",
                 "define chemical A\nuse chemical A diff 0.1\ncreate cell 5 5\ncreate cell 5 5\n"
                 "rule always change A conc RANDOM\n");
    CAPTURE(lines);
    const auto experiment = test::experiment(lines);

    const auto expected = test::on_reference(experiment);
    const auto found = test::on_device(experiment);

    test::check_equal_runs(*expected, *found, 10, 1);
}

TEST_CASE("free cells: mirror pairs, also where pairs share cells") {
    const auto experiment = test::experiment(verify::cell_tissue +
                                             "rule probability 0.1 change A diff 0.01\nrule probability 0.02 divide\n");
    Snapshot initial = initial_state(*experiment);
    initial.mirrors = {{0, 12}, {1, 11}, {11, 2}, {100, 5}, {5, 12}, {7, 8}};

    const auto expected = make_reference_cells(experiment, initial, Precision::single_);
    CellsOptions options;
    options.together = GENERATE(false, true);
    const auto found = test::on_device(experiment, options);
    found->write(initial);

    test::check_equal_runs(*expected, *found, 40, 8);
    CHECK(found->read().mirrors == initial.mirrors);
}
