// Rules: timing, conditions, parameters.
#include "language/parsed.hpp"

#include <catch2/catch.hpp>

using namespace pelage;
using namespace test;

TEST_CASE("a rule without timing is always active") {
    const Rule rule = rule_on_grid("rule always and");

    CHECK(rule.line == 4);
    CHECK(rule.from == 0);
    CHECK(rule.until == forever);
    CHECK(rule.every == 1);
    CHECK(rule.offset == 0);
    CHECK(rule.origin == 0);
    CHECK(std::holds_alternative<Always>(rule.condition));
    CHECK(std::holds_alternative<And>(rule.action));
}

TEST_CASE("timing") {
    const Rule rule = rule_on_grid("rule from 20 until 90 every 7 offset 3 always and");

    CHECK(rule.from == 20);
    CHECK(rule.until == 90);
    CHECK(rule.every == 7);
    CHECK(rule.offset == 3);
    CHECK(rule.active(24));
    CHECK(rule.active(87));
    CHECK_FALSE(rule.active(25));
    CHECK_FALSE(rule.active(17));
    CHECK_FALSE(rule.active(94));
}

TEST_CASE("an interval that ends before it begins never comes, as published") {
    const Rule rule = rule_on_grid("rule from 2500 until 2000 always and");

    CHECK(rule.from == 2500);
    CHECK(rule.until == 2000);
    CHECK_FALSE(rule.active(2250));
}

TEST_CASE("comparisons") {
    const std::pair<const char*, Comparison> all[] = {{"==", Comparison::equal},  {"!=", Comparison::not_equal},
                                                      {"<", Comparison::less},    {"<=", Comparison::less_equal},
                                                      {">", Comparison::greater}, {">=", Comparison::greater_equal}};
    for (const auto& [word, comparison] : all) {
        const Rule rule = rule_on_grid(std::string("rule if V conc ") + word + " 0.5 and");

        const auto compare = std::get<Compare>(rule.condition);
        CHECK(compare.comparison == comparison);
        CHECK(compare.left == Operand::concentration(1));
        CHECK(compare.right == Operand::number(0.5));
    }
}

TEST_CASE("intervals and probabilities") {
    const auto within = std::get<Within>(rule_on_grid("rule if AGE in 1 V diff and").condition);
    CHECK(within.value.quantity == Quantity::age);
    CHECK(within.low == Operand::number(1.0));
    CHECK(within.high == Operand::rate(1));

    CHECK(std::get<Probability>(rule_on_grid("rule probability 0.001 and").condition).chance == Operand::number(0.001));
    CHECK(std::get<Probability>(rule_on_grid("rule probability U conc and").condition).chance ==
          Operand::concentration(0));
}

TEST_CASE("every parameter") {
    const std::pair<const char*, Operand> all[] = {
        {"+0.01", Operand::number(0.01)},
        {"-.5", Operand::number(-0.5)},
        {"2.", Operand::number(2.0)},
        {"1e-3", Operand::number(0.001)},
        {"NEIGHBORS", {Quantity::neighbours, 0.0, 0}},
        {"AGE", {Quantity::age, 0.0, 0}},
        {"BIRTH", {Quantity::birth, 0.0, 0}},
        {"X", {Quantity::x, 0.0, 0}},
        {"Y", {Quantity::y, 0.0, 0}},
        {"ROW", {Quantity::row, 0.0, 0}},
        {"COLUMN", {Quantity::column, 0.0, 0}},
        {"ROWS", {Quantity::rows, 0.0, 0}},
        {"COLUMNS", {Quantity::columns, 0.0, 0}},
        {"ITERATION", {Quantity::iteration, 0.0, 0}},
        {"RANDOM", {Quantity::random, 0.0, 0}},
        {"U conc", Operand::concentration(0)},
        {"V diff", Operand::rate(1)},
    };
    for (const auto& [text, operand] : all) {
        const auto change = action_on_grid<Change>(std::string("rule always change U conc ") + text);

        INFO(text);
        CHECK(change.amount == operand);
    }
}

TEST_CASE("a mapping is a parameter from the line that computes it on") {
    const Experiment e = parsed_on_grid(
        "rule always map U conc 1 7 to BETA 10 12\n"
        "rule always map V diff -1 +1 to S 0 0.5\n"
        "rule always map BETA 1 0 to BETA 3 4\n"
        "rule always react U V scale S turing alpha 16 beta BETA\n");

    CHECK(e.mappings == std::vector<std::string>{"BETA", "S"});
    const auto map = std::get<Map>(e.rules.at(0).action);
    CHECK(map.value == Operand::concentration(0));
    CHECK(map.from_low == 1.0);
    CHECK(map.from_high == 7.0);
    CHECK(map.mapping == 0);
    CHECK(map.to_low == 10.0);
    CHECK(map.to_high == 12.0);
    CHECK(std::get<Map>(e.rules[1].action).mapping == 1);
    CHECK(std::get<Map>(e.rules[2].action).mapping == 0);
    CHECK(std::get<Map>(e.rules[2].action).value == Operand{Quantity::mapping, 0.0, 0});
    const auto react = std::get<React>(e.rules[3].action);
    CHECK(react.scale == Operand{Quantity::mapping, 0.0, 1});
    CHECK(react.parameters.at(1) == Operand{Quantity::mapping, 0.0, 0});
}

TEST_CASE("rules carry their line") {
    const Experiment e = parsed_on_grid("\n// comment\nrule always and\n\nrule always change U conc 1\n");

    CHECK(e.rules.at(0).line == 6);
    CHECK(e.rules.at(1).line == 8);
}
