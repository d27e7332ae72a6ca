// Charges in the language: what is understood, and what is refused with line and column.
#include "language/error_case.hpp"
#include "language/parse.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

const std::string charges_start = "define chemical order\ndefine chemical phi\ncreate charges 8 6 at 1 2\n";

std::string charges_message(const std::string& text) {
    try {
        parse_experiment(text, "t.pex", ".");
    } catch (const std::exception& error) {
        return error.what();
    }
    return "(none)";
}

}  // namespace

TEST_CASE("an aggregate is read with all its words in any order") {
    const Experiment e = parse_experiment(
        charges_start + "rule every 2 always aggregate phi order towards 3 (ITERATION) strength 4 radius 2 eta 6\n",
        "t.pex", ".");
    const auto& made = std::get<CreateMatrix>(e.prepattern.at(0));
    CHECK(made.charges);
    CHECK(made.columns == 8);
    CHECK(made.rows == 6);
    CHECK(made.x == 1.0);
    const auto& aggregate = std::get<Aggregate>(e.rules.at(0).action);
    CHECK(aggregate.order == 1);
    CHECK(aggregate.potential == 0);
    CHECK(aggregate.eta == Operand::number(6));
    CHECK(aggregate.radius == Operand::number(2));
    CHECK(aggregate.x == Operand::number(3));
    CHECK(aggregate.y.quantity == Quantity::iteration);
    CHECK(aggregate.strength == Operand::number(4));
}

TEST_CASE("an aggregate that means nothing is refused") {
    const std::string rule = "rule always aggregate order phi\n";
    CHECK_THAT(charges_message(charges_start + "rule always aggregate order order\n"),
               Contains("t.pex:4:29") && Contains("two different"));
    CHECK_THAT(charges_message(charges_start + "rule if X > 1 aggregate order phi\n"),
               Contains("'aggregate' takes the condition 'always'"));
    CHECK_THAT(charges_message(charges_start + "rule always aggregate order phi towards 1 2\n"), Contains("strength"));
    CHECK_THAT(charges_message(charges_start + rule + "create charges 2 2\n"), Contains("holds all cells"));
    CHECK_THAT(charges_message("define chemical order\ndefine chemical phi\ncreate charges 40000 2\n" + rule),
               Contains("32768"));
    CHECK_THAT(charges_message("define chemical order\ndefine chemical phi\ncreate matrix 4 2\n" + rule),
               Contains("t.pex:4") && Contains("create charges COLUMNS ROWS"));
    CHECK_THAT(charges_message(charges_start), Contains("need a rule that says 'aggregate'"));
    CHECK_THAT(charges_message(charges_start + rule + "rule always change phi conc 1\n"),
               Contains("t.pex:5") && Contains("no rule but"));
    CHECK_THAT(charges_message(charges_start + rule + "rule every 2 always aggregate phi order\n"),
               Contains("same chemicals"));
    CHECK_THAT(charges_message("define chemical order limit 1\ndefine chemical phi\ncreate charges 4 2\n" + rule),
               Contains("takes no bounds"));
    CHECK_THAT(charges_message(
                   "define chemical order\ndefine chemical phi\nuse chemical phi diff 1\ncreate charges 4 2\n" + rule),
               Contains("nothing diffuses"));
}
