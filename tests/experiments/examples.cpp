// docs/language-by-example.md: each line runs, and no word is left out.
#include "core/functions.hpp"
#include "core/models.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "language/vocabulary.hpp"
#include "reference/backend.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

using namespace pelage;

namespace {

struct Example {
    std::string statement;
    std::string text;  // with the lines around it
};

std::string around(const std::string& frame, const std::string& statement) {
    std::string text = frame;
    const std::size_t at = text.find("...\n");
    REQUIRE(at != std::string::npos);
    // An `and` joins the rule behind it.
    return text.replace(at, 4, statement + (statement.ends_with(" and") ? "\nrule always set W conc 1\n" : "\n"));
}

std::vector<Example> examples() {
    std::ifstream page(PELAGE_SOURCE "/docs/language-by-example.md");
    std::vector<Example> all;
    std::string frame;
    bool listing = true;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("    ")) {
            if (listing) frame.clear();
            listing = false;
            frame += line.substr(4) + "\n";
        } else if (line.starts_with("- `")) {
            listing = true;
            const std::string statement = line.substr(3, line.find("` : ") - 3);
            all.push_back({statement, around(frame, statement)});
        }
    }
    return all;
}

}  // namespace

TEST_CASE("every line of the language by example is carried out") {
    const std::vector<Example> all = examples();
    REQUIRE(all.size() > 80);
    const auto backend = reference_backend(Precision::single_);
    for (const Example& example : all) {
        INFO(example.statement);
        const Experiment experiment = parse_experiment(example.text, "example.pex", ".");
        const auto tissue = backend->make_tissue(experiment, initial_state(experiment));
        REQUIRE_NOTHROW(tissue->advance(3));
        REQUIRE_FALSE(tissue->non_finite().has_value());
    }
}

TEST_CASE("the language by example has every action, condition, quantity, reaction and function") {
    std::string page;
    for (const Example& example : examples()) page += example.text;
    std::vector<std::string> words;
    for (const auto& list : {language::words_of_actions(), language::words_of_conditions(),
                             language::words_of_quantities(), language::words_of_comparisons()}) {
        for (const std::string_view word : list) words.emplace_back(word);
    }
    for (const ModelFacts& model : model_table()) words.push_back(" " + std::string(model.word) + " ");
    for (const FunctionFacts& function : function_table()) words.push_back(function.name + "(");
    for (const std::string& word : words) {
        INFO(word);
        CHECK(page.find(word) != std::string::npos);
    }
}
