// Actions of rules.
#include "language/parsed.hpp"

#include <catch2/catch.hpp>

using namespace pelage;
using namespace test;

TEST_CASE("reactions take their parameters in order") {
    for (std::size_t model = 0; model < model_table().size(); ++model) {
        const ModelFacts& facts = model_table()[model];
        if (facts.species.size() != 2) continue;
        std::string text = "rule always react V U " + facts.word;
        for (std::size_t i = 0; i < facts.parameters.size(); ++i) {
            text += " " + facts.parameters[i].name + " " + std::to_string(i + 1);
        }
        const auto react = action_on_grid<React>(text);

        INFO(text);
        CHECK(react.model == Model{model});
        CHECK(react.species == std::vector<std::size_t>{1, 0});
        CHECK(react.scale == Operand::number(1.0));
        REQUIRE(react.parameters.size() == facts.parameters.size());
        for (std::size_t i = 0; i < react.parameters.size(); ++i) {
            CHECK(react.parameters[i] == Operand::number(static_cast<double>(i + 1)));
        }
    }
}

TEST_CASE("reinforcement takes one chemical") {
    const auto react = action_on_grid<React>("rule always react V scale 0.5 reinforcement threshold 5 width U conc");

    CHECK(react.model == model_named("reinforcement"));
    CHECK(react.species == std::vector<std::size_t>{1});
    CHECK(react.scale == Operand::number(0.5));
    CHECK(react.parameters == std::vector<Operand>{Operand::number(5.0), Operand::concentration(0)});
}

TEST_CASE("a chemical may bear a name that is a word elsewhere") {
    const Experiment e = parsed(
        "define chemical scale\ndefine chemical conc\ncreate sqr_grid 2 2\nuse chemical conc conc 3\n"
        "rule if conc conc > 1 react scale conc scale conc diff turing alpha 16 beta 12\n");

    const auto react = std::get<React>(e.rules.at(0).action);
    CHECK(react.species == std::vector<std::size_t>{0, 1});
    CHECK(react.scale == Operand::rate(1));
}

TEST_CASE("change adds and set replaces") {
    const auto conc = action_on_grid<Change>("rule always change V conc -2 dev 0.5");
    CHECK(conc.target == Target::concentration);
    CHECK(conc.chemical == 1);
    CHECK(conc.amount == Operand::number(-2.0));
    CHECK(conc.deviation == 0.5);
    const auto rate = action_on_grid<Change>("rule always change U diff V conc");
    CHECK(rate.target == Target::rate);
    CHECK(rate.amount == Operand::concentration(1));
    CHECK(rate.deviation == 0.0);

    const auto copy = action_on_grid<pelage::Set>("rule always set U conc V conc");
    CHECK(copy.target == Target::concentration);
    CHECK(copy.chemical == 0);
    CHECK(copy.value == Operand::concentration(1));
    CHECK(action_on_grid<pelage::Set>("rule always set V diff 0").target == Target::rate);
}

TEST_CASE("polarize, divide and move") {
    CHECK(action_on_grid<Polarize>("rule always polarize V conc").chemical == 1);

    const auto plain = action_on_grid<Divide>("rule always divide");
    CHECK(plain.direction == Operand::number(0.0));
    CHECK(plain.deviation == 0.0);
    const auto aimed = action_on_grid<Divide>("rule probability 0.1 divide direction 137.5 dev 180");
    CHECK(aimed.direction == Operand::number(137.5));
    CHECK(aimed.deviation == 180.0);

    const auto move = action_on_grid<Move>("rule always move U conc dev 0.25");
    CHECK(move.distance == Operand::concentration(0));
    CHECK(move.deviation == 0.25);
}

TEST_CASE("expand") {
    const auto plain = std::get<Expand>(rule_on_matrix("rule always expand columns 2").action);
    CHECK(plain.columns == 2);
    CHECK(plain.rows == 0);
    CHECK_FALSE(plain.rows_first);
    CHECK(plain.distribution == Distribution::uniform);
    CHECK(plain.band_weight == 1.0);

    const Rule rule = rule_on_matrix(
        "rule every 50 offset 1 always expand rows 1 weight 0.5 rows 0.45 to 0.55 first rows columns 3 "
        "distribution triangular");
    const auto full = std::get<Expand>(rule.action);
    CHECK(rule.every == 50);
    CHECK(rule.offset == 1);
    CHECK(full.columns == 3);
    CHECK(full.rows == 1);
    CHECK(full.rows_first);
    CHECK(full.distribution == Distribution::triangular);
    CHECK(full.band_weight == 0.5);
    CHECK(full.band_rows);
    CHECK(full.band_low == 0.45);
    CHECK(full.band_high == 0.55);
    const auto columns =
        std::get<Expand>(rule_on_matrix("rule every 50 always expand columns 1 weight 2 columns 0 to 1").action);
    CHECK_FALSE(columns.band_rows);
}

TEST_CASE("an expansion by interpolation") {
    CHECK_FALSE(std::get<Expand>(rule_on_matrix("rule always expand columns 2").action).interpolation);
    const std::pair<const char*, Interpolation> all[] = {{"nearest", Interpolation::nearest},
                                                         {"bilinear", Interpolation::bilinear},
                                                         {"bicubic", Interpolation::bicubic}};
    for (const auto& [word, interpolation] : all) {
        const Rule rule = rule_on_matrix(std::string("rule every 9 always expand by ") + word + " rows 3 columns 1");
        const auto expand = std::get<Expand>(rule.action);

        CHECK(expand.interpolation == interpolation);
        CHECK(expand.rows == 3);
        CHECK(expand.columns == 1);
    }
}

TEST_CASE("distributions of an expansion") {
    const std::pair<const char*, Distribution> all[] = {{"uniform", Distribution::uniform},
                                                        {"shuffled", Distribution::shuffled},
                                                        {"normal", Distribution::normal},
                                                        {"triangular", Distribution::triangular}};
    for (const auto& [word, distribution] : all) {
        const Rule rule = rule_on_matrix(std::string("rule every 9 always expand rows 1 distribution ") + word);

        CHECK(std::get<Expand>(rule.action).distribution == distribution);
    }
}
