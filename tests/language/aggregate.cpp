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

TEST_CASE("sites of charges may be those where an expression holds, which has no name among fields") {
    const std::string chemicals = "define chemical order\ndefine chemical phi\ndefine chemical family\n";
    const Experiment e = parse_experiment(
        chemicals +
            "define parameter wide 3\ndefine field away (hypot(X, Y))\n"
            "create charges 8 6 where (away < wide and RANDOM < 0.5) at 1 2\ndefine field after (ROW)\n"
            "set cell 20 chemical order conc (after)\nrule always aggregate order phi eta 2 seed family\n",
        "t.pex", ".");
    const auto& made = std::get<CreateMatrix>(e.prepattern.at(0));
    CHECK(made.where == 1);
    CHECK(made.y == 2.0);
    CHECK(e.fields.at(1).name.empty());
    CHECK(e.fields.at(2).name == "after");
    CHECK(std::get<Aggregate>(e.rules.at(0).action).seed == 2);

    const auto refused = [&](const std::string& rest) { return charges_message(chemicals + rest); };
    CHECK_THAT(refused("create charges 8 6 where\n"), Contains("t.pex:4:") && Contains("expression in parentheses"));
    CHECK_THAT(refused("create charges 8 6 where (order)\n"), Contains("t.pex:4:27"));
    CHECK_THAT(refused("create charges 8 6 where (ITERATION < 3)\n"), Contains("t.pex:4:27"));
    CHECK_THAT(refused("create charges 8 6 where (X) where (Y)\n"), Contains("t.pex:4:30") && Contains("where"));
    CHECK_THAT(refused("create matrix 8 6 where (X)\n"), Contains("t.pex:4:19"));
    const std::string unknown = refused("create charges 8 6 where (X)\ndefine field wall (moss)\n");
    CHECK_THAT(unknown, Contains("t.pex:5:20") && Contains("ROW") && !Contains(", ,"));
    CHECK_THAT(refused("create charges 8 6 where (X)\nrule always aggregate order phi eta moss\n"),
               Contains("t.pex:5:37") && !Contains(", ,") && !Contains(": ,"));
}

TEST_CASE("seeds of charges are kept in a chemical of their own, the same in all rules") {
    const std::string start = charges_start + "define chemical family\n";
    const std::string rule = "rule always aggregate order phi seed family\n";
    CHECK(charges_message(start + rule) == "(none)");
    CHECK(charges_message(start + "rule always aggregate order phi eta 2 seed phi\n") ==
          "t.pex:5:44: 'phi' holds something else of charges already; take another chemical");
    CHECK_THAT(charges_message(start + "rule always aggregate order phi seed\n"), Contains("t.pex:5:37"));
    CHECK_THAT(charges_message(start + "rule always aggregate order phi seed clan\n"),
               Contains("t.pex:5:38") && Contains("unknown chemical 'clan'"));
    CHECK_THAT(charges_message(start + rule + "rule every 2 always aggregate order phi\n"),
               Contains("t.pex:6") && Contains("same chemical"));
    CHECK_THAT(charges_message("define chemical order\ndefine chemical phi\ndefine chemical family limit 4\n"
                               "create charges 4 2\n" +
                               rule),
               Contains("'family'") && Contains("no bounds"));
}

TEST_CASE("the size of a new charge may be drawn, and is kept in a chemical of its own") {
    const std::string start = charges_start + "define chemical mass\n";
    const Experiment e =
        parse_experiment(start + "rule always aggregate order phi size mass (1 + RANDOM) eta 2\n", "t.pex", ".");
    const auto& aggregate = std::get<Aggregate>(e.rules.at(0).action);
    CHECK(aggregate.size == 2);
    CHECK(aggregate.grown.quantity == Quantity::expression);
    CHECK(charges_message(start + "rule always aggregate order phi size mass RANDOM\n") == "(none)");
    CHECK_THAT(charges_message(start + "rule always aggregate order phi size mass\n"),
               Contains("t.pex:5:42") && Contains("the size of a new charge must be one of"));
    CHECK_THAT(charges_message(start + "rule always aggregate order phi size 3\n"),
               Contains("t.pex:5:38") && Contains("unknown chemical '3'"));
    CHECK(charges_message(start + "rule always aggregate order phi seed mass size mass 2\n") ==
          "t.pex:5:48: 'mass' holds something else of charges already; take another chemical");
    CHECK_THAT(charges_message(start + "rule always aggregate order phi size mass X\n"),
               Contains("t.pex:5") && Contains("the same for all sites"));
    CHECK_THAT(
        charges_message(start + "rule always aggregate order phi size mass 2\nrule always aggregate order phi\n"),
        Contains("t.pex:6") && Contains("same chemicals"));
}

TEST_CASE("a far field is asked for by all rules or none, and not where a place draws the growth") {
    const Experiment e =
        parse_experiment(charges_start + "rule always aggregate order phi far-field eta 2\n", "t.pex", ".");
    CHECK(std::get<Aggregate>(e.rules.at(0).action).far_field);
    CHECK(std::get<Aggregate>(e.rules.at(0).action).eta == Operand::number(2));
    const std::string rule = "rule always aggregate order phi far-field\n";
    CHECK(charges_message(charges_start + rule + rule) == "(none)");
    CHECK_THAT(charges_message(charges_start + rule + "rule every 2 always aggregate order phi\n"),
               Contains("t.pex:5") && Contains("all `aggregate` rules of an experiment say `far-field`, or none"));
    CHECK_THAT(charges_message(charges_start + "rule always aggregate order phi far-field towards 1 2 strength 3\n"),
               Contains("t.pex:4:43: 'towards' and 'far-field' exclude each other"));
    CHECK_THAT(charges_message(charges_start + "rule always aggregate order phi far-field far-field\n"),
               Contains("'far-field'"));
}
