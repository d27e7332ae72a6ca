// The table of reactions, and how a kernel file declares its line of it.
#include "core/models.hpp"
#include "core/error.hpp"
#include "core/support_experiments.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <variant>

using namespace pelage;

TEST_CASE("a declaration names word, species and parameters with their ranges") {
    const ModelFacts facts = read_model(
        "three_kinds", "model three-kinds | a 0 to 1, b -2 to 2, c 0.5 to 1e3 kept | rate 0 to 0.25, k 1 to 2");

    CHECK(facts.word == "three-kinds");
    REQUIRE(facts.species.size() == 3);
    CHECK(facts.species[1].name == "b");
    CHECK(facts.species[1].low == -2);
    CHECK(facts.species[2].high == 1000);
    CHECK(facts.species[2].kept);
    CHECK(facts.changed() == 2);
    REQUIRE(facts.parameters.size() == 2);
    CHECK(facts.parameters[0].name == "rate");
    CHECK(facts.parameters[0].high == 0.25);
}

TEST_CASE("a declaration that cannot be understood is refused with file and reason") {
    const std::pair<const char*, const char*> wrong[] = {
        {"model x | u 0 to 1", "three parts"},
        {"model x | u 0 to 1 | a 0 to 1 | b 0 to 1", "three parts"},
        {"model y | u 0 to 1 | a 0 to 1", "begins with 'model x'"},
        {"reaction x | u 0 to 1 | a 0 to 1", "begins with 'model x'"},
        {"model x y | u 0 to 1 | a 0 to 1", "begins with 'model x'"},
        {"model x | | a 0 to 1", "a species is"},
        {"model x | u 0 to 1, | a 0 to 1", "a species is"},
        {"model x | u+ 0 to 1 | a 0 to 1", "a species is"},
        {"model x | u 0 to 1, u 0 to 2 | a 0 to 1", "'u' stands twice"},
        {"model x | u 0 to 1 | a 0 to 1, a 0 to 2", "'a' stands twice"},
        {"model x | u 0 to 1 | u 0 to 1", "'u' stands twice"},
        {"model x | u 1 to 0 | a 0 to 1", "a species is"},
        {"model x | u 0 to 1 held | a 0 to 1", "a species is"},
        {"model x | u 0 to 1 kept | a 0 to 1", "at least one"},
        {"model x | u 0 to 1 kept, v 0 to 1 | a 0 to 1", "kept species stand last"},
        {"model x | u 0 to 1 | a 0", "a parameter is"},
        {"model x | u 0 to 1 | a 0 to 1 kept", "a parameter is"},
    };
    for (const auto& [text, reason] : wrong) {
        INFO(text);
        CHECK_THROWS_WITH(read_model("x", text), Catch::Contains("kernels/models/x.cl:1") && Catch::Contains(reason));
    }
}

TEST_CASE("a reaction may have no parameters") { CHECK(read_model("x", "model x | u 0 to 1 |").parameters.empty()); }

TEST_CASE("'scale' is no name of a reaction, being a word of all of them") {
    CHECK_THROWS_WITH(read_model("scale", "model scale | u 0 to 1 | a 0 to 1"), Catch::Contains("every reaction"));
}

TEST_CASE("validation holds a reaction against the table") {
    const auto refused = [](const auto& change) {
        Experiment experiment = test::turing_matrix(8, 8);
        change(std::get<React>(experiment.rules[0].action));
        try {
            validate(experiment);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };

    CHECK(refused([](React&) {}).empty());
    CHECK_THAT(refused([](React& r) { r.model.index = model_table().size(); }), Catch::Contains("not in the table"));
    CHECK_THAT(refused([](React& r) { r.species = {0}; }), Catch::Contains("turing takes 2 chemicals; found 1"));
    CHECK_THAT(refused([](React& r) { r.species = {1, 1}; }), Catch::Contains("different chemicals"));
    CHECK_THAT(refused([](React& r) { r.species = {0, 7}; }), Catch::Contains("a reaction"));
    CHECK_THAT(refused([](React& r) { r.parameters.resize(11); }),
               Catch::Contains("turing takes 2 parameters; found 11"));
}

TEST_CASE("reactions are found by their words") {
    REQUIRE(!model_table().empty());
    for (std::size_t i = 0; i < model_table().size(); ++i) CHECK(model_named(model_table()[i].word).index == i);
    CHECK(model_named("gray-scott").facts().parameters[1].name == "k");
    CHECK_THROWS_WITH(model_named("grey-scott"), Catch::Contains("grey-scott") && Catch::Contains("turing"));
}
