// The generated table of cases: all pairs of values meet, and no word of the program is left out.
#include "verify/covering.hpp"

#include "core/functions.hpp"
#include "core/models.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "language/vocabulary.hpp"
#include "opencl/device/options.hpp"
#include "reference/backend.hpp"
#include "verify/array_factors.hpp"
#include "verify/array_text.hpp"
#include "verify/cases.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

using namespace pelage;
using namespace pelage::verify;

namespace {

Array small_array(std::size_t strength) {
    const auto any = [](const Choice&, const Choice&) { return true; };
    return {{{"a", {"0", "1", "2"}}, {"b", {"0", "1"}}, {"c", {"0", "1", "2", "3"}}, {"d", {"0", "1"}}}, strength, any};
}

std::vector<ArrayRow> all_rows(Realm realm, std::size_t strength) {
    std::vector<ArrayRow> rows;
    for (const GeneratedWorld& world : generated_worlds(realm, strength)) {
        rows.push_back(world.world);
        rows.insert(rows.end(), world.rules.begin(), world.rules.end());
    }
    return rows;
}

std::string text_of_line(const std::string& text, std::size_t line) {
    std::istringstream lines(text);
    std::string found;
    for (std::size_t i = 0; i < line; ++i) std::getline(lines, found);
    return found;
}

// Values of a factor of either realm.
std::set<std::string> values_of(const std::string& factor) {
    std::set<std::string> values;
    for (const Realm realm : {Realm::lattice, Realm::cells}) {
        for (const Factor& one : factors_of(realm)) {
            if (one.name == factor) values.insert(one.values.begin(), one.values.end());
        }
    }
    return values;
}

// Words that are in cases of their own: verify/cases_volume.cpp.
bool of_volumes_alone(std::string_view word) {
    static const std::set<std::string_view> words{"Z",          "LAYER",       "LAYERS",
                                                  "gradient_z", "seven-point", "twenty-seven-point"};
    return words.contains(word);
}

}  // namespace

TEST_CASE("a covering array has all pairs and all triples in few rows, and each row is needed") {
    for (const std::size_t strength : {2u, 3u}) {
        const Array array = small_array(strength);
        const Covering made = cover(array);
        CHECK(not_met(array, made.rows).empty());
        CHECK(made.infeasible == 0);
        CHECK(made.rows.size() <= (strength == 2 ? 16u : 36u));
        std::vector<ArrayRow> fewer = made.rows;
        fewer.erase(fewer.begin());
        CHECK_FALSE(not_met(array, fewer).empty());
    }
}

TEST_CASE("values that exclude each other stand in no row") {
    Array array = small_array(2);
    array.feasible = [](const Choice& a, const Choice& b) {
        const auto is = [](const Choice& choice, std::size_t factor) {
            return choice.factor == factor && choice.value == 1;
        };
        return !(is(a, 0) && is(b, 1)) && !(is(a, 1) && is(b, 0));
    };
    const Covering made = cover(array);
    CHECK(not_met(array, made.rows).empty());
    CHECK(made.infeasible == 1);
    for (const ArrayRow& row : made.rows) CHECK_FALSE((row[0] == 1 && row[1] == 1));
}

TEST_CASE("what no row of those given allows is infeasible, and found to be so at once") {
    Array array = small_array(2);
    array.given = {{0, 0}, {1, 1}};
    array.costs = {1, 1};
    const Covering made = cover(array);
    REQUIRE(made.of_given.size() == made.rows.size());
    for (std::size_t i = 0; i < made.rows.size(); ++i) CHECK(made.rows[i][0] == array.given[made.of_given[i]][0]);
    CHECK(made.infeasible == 4 + 4 + 2);  // 2 of a with all of c and d; a with b, none of which is given
}

TEST_CASE("in the generated experiments all pairs, and all triples of settings, meet that may") {
    const std::size_t strength = GENERATE(2u, 3u);
    CAPTURE(strength);
    for (const Realm realm : {Realm::lattice, Realm::cells}) {
        const Array worlds = world_array(realm, strength);
        CHECK(not_met(worlds, cover(worlds).rows).empty());
        const std::vector<std::string> missing = not_met(rule_array(realm, strength), all_rows(realm, strength));
        for (const std::string& tuple : missing) UNSCOPED_INFO(tuple);
        CHECK(missing.empty());
    }
}

TEST_CASE("experiments in which triples meet are of the language") {
    for (const Realm realm : {Realm::lattice, Realm::cells}) {
        for (const GeneratedWorld& world : generated_worlds(realm, 3)) {
            const GeneratedCase one{&world, realm, realm == Realm::lattice ? Size{17, 11} : Size{11, 5}};
            CHECK_NOTHROW(parse_experiment(generated_text(one), "generated", "."));
        }
    }
}

TEST_CASE("every action, quantity, condition, model, stencil and boundary is a value of a factor") {
    const std::set<std::string> actions = values_of("action");
    for (const std::string_view word : language::words_of_actions()) {
        INFO(word);
        if (word == "aggregate") continue;  // of a tissue of its own, tested in tests/aggregate
        const bool elsewhere = (word == "expand" && values_of("growth").contains("inserted")) ||
                               (word == "and" && values_of("joined").contains("and"));
        const bool named = std::ranges::any_of(
            actions, [&](const std::string& action) { return action.substr(0, action.find(' ')) == word; });
        CHECK((elsewhere || named));
    }
    for (const ModelFacts& model : model_table()) CHECK(actions.contains("react " + model.word));
    for (const std::string_view word : language::words_of_quantities()) {
        INFO(word);
        if (of_volumes_alone(word)) continue;
        CHECK(values_of("amount").contains(std::string(word)));
        CHECK(values_of("read").contains(std::string(word)));
    }
    for (const std::string_view word : language::words_of_comparisons()) {
        CHECK(values_of("condition").contains(std::string(word)));
    }
    for (const std::string_view word : language::words_of_conditions()) {
        INFO(word);
        CHECK((word == "if" || values_of("condition").contains(std::string(word))));
    }
    // Weights of five rows are in cases of their own and in random experiments: no iterations are fused with them.
    for (const std::string_view word : language::words_of_stencils())
        CHECK((word == "5x5" || of_volumes_alone(word) || values_of("stencil").contains(std::string(word))));
    for (const std::string_view word : language::words_of_boundaries())
        CHECK(values_of("boundary").contains(std::string(word)));
    for (const char* const path : path_words)
        CHECK((values_of("path").contains(path) || path == word(Path::automatic)));
}

TEST_CASE("every function, and every word that takes a chemical, is in some generated expression") {
    std::string all;
    for (const Realm realm : {Realm::lattice, Realm::cells}) {
        for (const GeneratedWorld& world : generated_worlds(realm, 2)) all += generated_text({&world, realm, {17, 11}});
    }
    for (const std::string_view word : language::words_of_chemicals()) {
        INFO(word);
        if (of_volumes_alone(word)) continue;
        const std::string name(word);
        CHECK((all.find(name + "(") != std::string::npos || all.find(" " + name + " ") != std::string::npos));
    }
    for (const FunctionFacts& function : function_table()) {
        INFO(function.name);
        CHECK(all.find(function.name + "(") != std::string::npos);
    }
}

TEST_CASE("generated experiments are of the language, and most of their rules change what comes out") {
    std::size_t rules = 0;
    std::vector<std::string> idle;
    for (const Realm realm : {Realm::lattice, Realm::cells}) {
        for (const GeneratedWorld& world : generated_worlds(realm, 2)) {
            const GeneratedCase whole{&world, realm, realm == Realm::lattice ? Size{17, 11} : Size{11, 5}};
            const Experiment experiment = parse_experiment(generated_text(whole), "generated", ".");
            Snapshot start = initial_state(experiment, Precision::single_);
            set_stage(whole, start);
            const auto after = [&](const Experiment& one) {
                const auto tissue = reference_backend(Precision::single_)->make_tissue(one, start);
                tissue->advance(20);
                return tissue->read();
            };
            const Snapshot expected = after(experiment);
            for (std::size_t i = 0; i < experiment.rules.size(); ++i) {
                Experiment without = experiment;
                without.rules[i].until = 0;
                without.rules[i].from = 1;
                const Snapshot found = after(without);
                ++rules;
                const bool same = found.conc == expected.conc && found.diff == expected.diff &&
                                  found.mappings == expected.mappings && found.x == expected.x &&
                                  found.polarity_x == expected.polarity_x;
                if (same) idle.push_back(text_of_line(generated_text(whole), experiment.rules[i].line));
            }
        }
    }
    CAPTURE(rules, idle);
    CHECK(rules > 600);
    CHECK(idle.size() < rules / 4);
}
