// What validate() refuses of experiments built by hand: starts out of bounds, rates below 0, numbers that are none.
#include "core/starts.hpp"

#include "core/error.hpp"
#include "core/support_experiments.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <string>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const double no_number = std::numeric_limits<double>::quiet_NaN();

std::string refusal(const Experiment& experiment) {
    try {
        validate(experiment);
    } catch (const Error& error) {
        return error.what();
    }
    return "(none)";
}

// The Turing matrix with one statement more before its cells, or after.
Experiment with(const Statement& statement, bool after = false) {
    Experiment experiment = test::turing_matrix(3, 2);
    auto& all = experiment.prepattern;
    all.insert(after ? all.end() : all.end() - 1, statement);
    return experiment;
}

Experiment bounded(Bounds bounds) {
    Experiment experiment = test::turing_matrix(3, 2);
    experiment.phases[0].bounds[0] = bounds;
    return experiment;
}

Experiment pictured(std::vector<double> values) {
    Experiment experiment = bounded({0.0, 1.0});
    experiment.chemicals[0].initial = std::make_shared<const Field>(Field{3, 2, std::move(values)});
    return experiment;
}

template <class Change>
Experiment changed(Change change) {
    Experiment experiment = test::turing_matrix(3, 2);
    change(experiment);
    return experiment;
}

}  // namespace

TEST_CASE("rates below 0 are refused on a lattice, and wherever a draw may give one") {
    CHECK_THAT(refusal(with(UseChemical{0, {}, Spread{-0.01, 0}})), Contains("rate -0.01 of 'U' is below 0"));
    CHECK_THAT(refusal(with(UseChemical{0, {}, Spread{0.05, 0.1}})),
               Contains("drawn from -0.05 to 0.15") && Contains("'dev' may be 0.05 at most"));
    CHECK_THAT(refusal(with(SetCells{0, 2, SetRate{1, {-1, 0}}}, true)), Contains("rate -1 of 'V' is below 0"));
    CHECK(refusal(with(UseChemical{0, {}, Spread{0.1, 0.1}})) == "(none)");
    CHECK(refusal(with(UseChemical{0, {}, Spread{0.3, 0.3}})) == "(none)");
    CHECK_THAT(refusal(changed([](Experiment& e) { e.phases[0].rates[1] = -1; })), Contains("not below 0"));
    CHECK_THAT(refusal(changed([](Experiment& e) { e.phases[0].rates[1] = no_number; })), Contains("not below 0"));
}

TEST_CASE("free cells may pump, which is a warning, a draw may not") {
    Experiment experiment = with(UseChemical{0, {}, Spread{-0.01, 0}});
    experiment.prepattern.back() = CreateCell{};
    CHECK(refusal(experiment) == "(none)");
    REQUIRE(start_faults(experiment).size() == 1);
    CHECK_FALSE(start_faults(experiment)[0].refused);
    CHECK(start_faults(experiment)[0].statement == 2u);
    experiment.prepattern[2] = UseChemical{0, {}, Spread{-0.01, 0.001}};
    CHECK_THAT(refusal(experiment), Contains("drawn from -0.011"));
}

TEST_CASE("starts outside the bounds are refused, a draw that is partly inside is cut") {
    CHECK_THAT(refusal(bounded({0, 2.5})), Contains("'U' starts between 3 and 5, outside its bounds 0 to 2.5"));
    CHECK_THAT(refusal(bounded({6, infinity})), Contains("outside its floor 6"));
    CHECK_THAT(refusal(bounded({-infinity, 2})), Contains("outside its limit 2"));
    CHECK(refusal(bounded({3.5, infinity})) == "(none)");
    REQUIRE(start_faults(bounded({3.5, 4.5})).size() == 1);
    CHECK(start_faults(bounded({3, 5})).empty());
    CHECK_THAT(refusal(with(UseChemical{1, Spread{-0.5, 0}, {}})), Contains("'V' starts at -0.5, outside its floor 0"));
    CHECK_THAT(refusal(with(SetCells{0, 0, SetConcentration{1, {-1, 0}}}, true)), Contains("'V' starts at -1"));
}

TEST_CASE("a chemical of which nothing is said starts at 0, which must lie within its bounds") {
    Experiment experiment = bounded({1, infinity});
    experiment.prepattern.erase(experiment.prepattern.begin());
    REQUIRE(start_faults(experiment).size() == 1);
    CHECK_THAT(start_faults(experiment)[0].text, Contains("'U' starts at 0, outside its floor 1"));
    CHECK(refusal(experiment) == "(none)");  // a state may be given by hand
    experiment.prepattern.emplace_back(SetCells{0, 5, SetConcentration{0, {2, 0}}});
    CHECK(start_faults(experiment).empty());
}

TEST_CASE("a start picture must lie within the bounds, up to a rounding in float") {
    CHECK(refusal(pictured({0, 0.5, 1, 1 + 1e-12, -1e-300, 0})) == "(none)");
    CHECK_THAT(refusal(pictured({0, 0.5, 1.25, 0, 0, 0})),
               Contains("picture of 'U' holds 0 to 1.25, outside its bounds 0 to 1"));
    CHECK_THAT(refusal(pictured({0, -0.5, 1, 0, 0, 0})), Contains("holds -0.5 to 1"));
}

TEST_CASE("a time step that is 0 in float, and numbers that are none, are refused") {
    CHECK_THAT(refusal(changed([](Experiment& e) { e.phases[0].time_step = 1e-46; })),
               Contains("no less than 1.18e-38"));
    CHECK_THAT(refusal(changed([](Experiment& e) { e.phases[0].time_step = 1e-39; })),
               Contains("no less than 1.18e-38"));
    CHECK(refusal(changed([](Experiment& e) { e.phases[0].time_step = 2e-38; })) == "(none)");
    CHECK_THAT(refusal(changed([](Experiment& e) {
                   e.phases[0].bounds[0] = {infinity, infinity};
               })),
               Contains("bounds that no number meets"));
    CHECK_THAT(refusal(with(UseChemical{0, Spread{infinity, 0}, {}})), Contains("a concentration must be a number"));
    CHECK_THAT(refusal(with(UseChemical{0, Spread{4, no_number}, {}})),
               Contains("a deviation is a number not below 0"));
    CHECK_THAT(refusal(with(UsePolarity{Spread{no_number, 0}})), Contains("a polarity must be a number"));
    CHECK_THAT(refusal(changed([](Experiment& e) { e.domain.width = infinity; })), Contains("the domain's width"));
    CHECK_THAT(refusal(changed([](Experiment& e) { e.domain.height = 1e-50; })), Contains("the domain's width"));
    CHECK_THAT(refusal(changed([](Experiment& e) {
                   e.rules[0].action = Change{Target::concentration, 0, Operand::number(1), -1};
               })),
               Contains("a deviation is a number not below 0"));
    CHECK_THAT(refusal(changed([](Experiment& e) {
                   e.mappings = {"M"};
                   e.rules[0].action = Map{Operand::number(1), 1.0, 1.0 + 1e-12, 0, 0, 1};
               })),
               Contains("two different source limits"));
}
