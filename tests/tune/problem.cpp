// What candidates are tried on, and what makes two experiments alike.
#include "tune/problem.hpp"

#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "lattices.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace pelage;
using namespace pelage::tune;
using test::spots;
using test::spots_text;

TEST_CASE("experiments that differ in numbers, results and comments alone are of one class") {
    const std::string text = spots_text(100, 80);
    const std::string other = "// Other spots.\n\n" + spots_text(300, 20, "output U colormap gray\n");

    CHECK(rules_class(text) == rules_class(other));
    CHECK(rules_class(text) != rules_class(spots_text(100, 80, "rule always change U conc 0.1\n")));
}

TEST_CASE("sizes are of one class up to the nearest power of two") {
    CHECK(size_class({1000, 1}) == "1024 x 1");
    CHECK(size_class({1400, 600}) == "1024 x 512");
    CHECK(size_class({1500, 800}) == "2048 x 1024");
}

TEST_CASE("a small lattice is verified and timed as it is") {
    const Problem problem = make_problem(spots(50, 40), 7, 5000, 1'000'000);

    CHECK(problem.verified.start.columns == 50);
    CHECK(problem.timed.start.rows == 40);
    CHECK(problem.timed.start.iteration == 7);
    CHECK(problem.end == 5000);
    CHECK(problem.timed.start.conc == initial_state(spots(50, 40)).conc);
}

TEST_CASE("a large lattice is cut down to no more cells than are wanted, by halving its longer side") {
    const Problem problem = make_problem(spots(4000, 1000), 0, 10, 300'000);

    CHECK(problem.timed.start.columns == 500);
    CHECK(problem.timed.start.rows == 500);
    CHECK(problem.verified.start.columns % 2 == 1);
    CHECK(problem.verified.start.rows % 2 == 1);
    CHECK(problem.end == 1000);
}

TEST_CASE("what is verified is not flat, whatever the experiment begins with") {
    const Experiment flat = parse_experiment(
        "define chemical U limit 1\nuse chemical U conc 1 diff 0.1\ncreate matrix 30 20\nstop at 10\n", "flat", ".");

    const Snapshot start = make_problem(flat, 0, 10, 1000).verified.start;

    const std::set<double> values(start.conc[0].begin(), start.conc[0].end());
    CHECK(values.size() > 100);
    CHECK(*values.rbegin() <= 1.0);
}

TEST_CASE("pictures and cells set by number are cut down too") {
    Experiment experiment = spots(40, 30, "set cell 5 chemical U conc 1\nset cells 190 to 1199 chemical U conc 2\n");
    Field field{40, 30, std::vector<double>(1200)};
    for (std::size_t i = 0; i < field.values.size(); ++i) field.values[i] = static_cast<double>(i);
    experiment.chemicals[1].initial = std::make_shared<const Field>(field);

    const Snapshot small = initial_state(cut_down(experiment, {20, 10}));

    CHECK(small.cells() == 200);
    CHECK(small.conc[0][5] == 1.0);
    CHECK(small.conc[1][20] == 40.0);
}

TEST_CASE("free cells have nothing to tune") {
    const Experiment cells = parse_experiment("define chemical U\ncreate hex_circle 3\nstop at 10\n", "cells.pex", ".");

    CHECK_THROWS_WITH(lattice_size(cells), Catch::Contains("cells.pex") && Catch::Contains("nothing to tune"));
}
