// The generated table of cases: all pairs of values meet, and no word of the program is left out.
#include "verify/covering.hpp"

#include "core/functions.hpp"
#include "core/models.hpp"
#include "core/prepattern.hpp"
#include "language/vocabulary.hpp"
#include "opencl/device/options.hpp"
#include "reference/backend.hpp"
#include "verify/array_factors.hpp"
#include "verify/array_text.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

using namespace pelage;
using namespace pelage::verify;

namespace {

constexpr std::size_t npos = std::string::npos;

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

GeneratedCase small_case(const GeneratedWorld& world, Realm realm) {
    const bool sphere = Values(realm, world.world).has("shape", "icosphere");
    if (realm == Realm::charges) return {&world, realm, charges_size(world)};
    const Size sizes[] = {{17, 11}, {11, 5}, {7, 5, 4}, sphere ? Size{2, 0} : Size{9, 6}};
    return {&world, realm, sizes[static_cast<std::size_t>(realm)]};
}

std::string text_of_line(const std::string& text, std::size_t line) {
    std::istringstream lines(text);
    std::string found;
    for (std::size_t i = 0; i < line; ++i) std::getline(lines, found);
    return found;
}

std::set<std::string> values_of(const std::string& factor, Realm realm) {
    for (const Factor& one : factors_of(realm)) {
        if (one.name == factor) return {one.values.begin(), one.values.end()};
    }
    return {};
}

// Of every realm.
std::set<std::string> values_of(const std::string& factor) {
    std::set<std::string> values;
    for (const Realm realm : every_realm) values.merge(values_of(factor, realm));
    return values;
}

// Where not all that the language says of cells means anything.
bool refused(Realm realm, std::string_view word) {
    static const std::set<std::string_view> of_grids{"ROW", "COLUMN", "ROWS", "COLUMNS", "LAYER", "LAYERS"};
    if (realm == Realm::mesh) return of_grids.contains(word);
    if (realm == Realm::volume) return false;
    return word == "Z" || word == "LAYER" || word == "LAYERS" || (realm == Realm::cells && of_grids.contains(word));
}

// All of a realm's experiments as text.
std::string texts_of(Realm realm) {
    std::string all;
    for (const GeneratedWorld& world : generated_worlds(realm, 2)) all += generated_text(small_case(world, realm));
    return all;
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
    for (const Realm realm : every_realm) {
        const Array worlds = world_array(realm, strength);
        CHECK(not_met(worlds, cover(worlds).rows).empty());
        const std::vector<std::string> missing = not_met(rule_array(realm, strength), all_rows(realm, strength));
        for (const std::string& tuple : missing) UNSCOPED_INFO(tuple);
        CHECK(missing.empty());
    }
}

// Margins that go round more than once are wrong only where rows and columns are wrapped, and passes are as deep as the
// strides.
TEST_CASE("on each fused path the deepest passes meet wrapped lattices that are lower, and narrower, than they reach") {
    const std::string path = GENERATE("streamed", "tiled");
    bool low = false, narrow = false;
    for (const GeneratedWorld& world : generated_worlds(Realm::lattice, 2)) {
        const Values values(Realm::lattice, world.world);
        if (values["path"] != path || values["boundary"] != "wrap" || values["cut"] != "whole") continue;
        CHECK(values["growth"] == "none");
        CHECK(values["intervals"] == "compiled");
        for (const Size& size : generated_sizes(world, Realm::lattice)) {
            const std::uint64_t reach = std::ranges::max(generated_strides(size, Realm::lattice));
            low = low || (size.rows < size.columns && size.rows < reach);
            narrow = narrow || (size.columns < size.rows && size.columns < reach);
        }
    }
    CHECK(low);
    CHECK(narrow);
}

// Of a torus two strips already meet at both ends: those of a volume are as low as its passes allow.
TEST_CASE("on a wrapped volume that is cut small nothing breaks off the passes") {
    bool unbroken = false;
    for (const GeneratedWorld& world : generated_worlds(Realm::volume, 2)) {
        const Values values(Realm::volume, world.world);
        unbroken = unbroken || (values["cut"] == "small" && values["boundary"] == "wrap" &&
                                values["extent"] == "several" && values["intervals"] == "compiled");
    }
    CHECK(unbroken);
}

TEST_CASE("experiments in which triples meet are of the language") {
    for (const Realm realm : every_realm) {
        for (const GeneratedWorld& world : generated_worlds(realm, 3)) {
            const GeneratedCase one = small_case(world, realm);
            INFO(generated_text(one));
            CHECK_NOTHROW(generated_experiment(one, generated_text(one)));
        }
    }
}

TEST_CASE("every action, quantity, condition, model, stencil and boundary is a value of a factor") {
    const std::set<std::string> actions = values_of("action");
    for (const std::string_view word : language::words_of_actions()) {
        INFO(word);
        const bool elsewhere = (word == "expand" && values_of("growth").contains("inserted")) ||
                               (word == "and" && values_of("joined").contains("and")) ||
                               (word == "aggregate" && texts_of(Realm::charges).find(" aggregate ") != npos);
        const bool named = std::ranges::any_of(
            actions, [&](const std::string& action) { return action.substr(0, action.find(' ')) == word; });
        CHECK((elsewhere || named));
    }
    for (const ModelFacts& model : model_table()) CHECK(actions.contains("react " + model.word));
    for (const Realm realm : {Realm::lattice, Realm::cells, Realm::volume, Realm::mesh}) {
        for (const std::string_view quantity : language::words_of_quantities()) {
            INFO(quantity << " in a " << word(realm));
            if (refused(realm, quantity)) continue;
            CHECK(values_of("amount", realm).contains(std::string(quantity)));
            CHECK(values_of("read", realm).contains(std::string(quantity)));
        }
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
        CHECK((word == "5x5" || values_of("stencil").contains(std::string(word))));
    for (const std::string_view word : language::words_of_aggregates())
        CHECK(texts_of(Realm::charges).find(" " + std::string(word) + " ") != npos);
    for (const std::string_view word : language::words_of_boundaries()) {
        CHECK(values_of("boundary", Realm::lattice).contains(std::string(word)));
        CHECK(values_of("boundary", Realm::volume).contains(std::string(word)));
    }
    for (const char* const path : path_words)
        CHECK((values_of("path").contains(path) || path == word(Path::automatic)));
}

TEST_CASE("every function, and every word that takes a chemical, is in some generated expression") {
    std::string all;
    for (const Realm realm : every_realm) all += texts_of(realm);
    for (const std::string_view word : language::words_of_chemicals()) {
        INFO(word);
        const std::string name(word);
        CHECK((all.find(name + "(") != npos || all.find(" " + name + " ") != npos));
    }
    for (const FunctionFacts& function : function_table()) {
        INFO(function.name);
        CHECK(all.find(function.name + "(") != npos);
    }
}

TEST_CASE("generated experiments are of the language, and most of their rules change what comes out") {
    std::size_t rules = 0;
    std::vector<std::string> idle;
    for (const Realm realm : every_realm) {
        for (const GeneratedWorld& world : generated_worlds(realm, 2)) {
            const GeneratedCase whole = small_case(world, realm);
            const Experiment experiment = generated_experiment(whole, generated_text(whole));
            Snapshot start = initial_state(experiment, Precision::single_);
            set_stage(whole, start);
            const auto after = [&](const Experiment& one) {
                const auto tissue = reference_backend(Precision::single_)->make_tissue(one, start);
                tissue->advance(20);
                return tissue->read();
            };
            const Snapshot expected = after(experiment);
            CHECK(expected.conc != start.conc);
            for (std::size_t i = 0; i < experiment.rules.size(); ++i) {
                if (!has_rules(realm)) continue;
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
    CHECK(rules > 700);
    CHECK(idle.size() < rules / 4);
}
