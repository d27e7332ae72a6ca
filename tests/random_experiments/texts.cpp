// The drawn texts: valid, the same everywhere, and made of all words of the language.
#include "core/error.hpp"
#include "core/models.hpp"
#include "core/prepattern.hpp"
#include "core/stability.hpp"
#include "language/parse.hpp"
#include "support/random_runs.hpp"
#include "verify/random_experiment.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace pelage;
using namespace pelage::verify;

namespace {

constexpr std::uint64_t seeds = 500;

// Words outside of quotes and remarks.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    bool quoted = false;
    std::string word;
    const auto end_word = [&] {
        if (!word.empty()) words.push_back(word);
        word.clear();
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (!quoted && line.compare(i, 2, "//") == 0) break;
        const bool blank = line[i] == ' ' || line[i] == '\t' || line[i] == '\r' || line[i] == '"';
        if (blank || quoted)
            end_word();
        else
            word += line[i];
    }
    end_word();
    return words;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// All of the language, but for the names of colours and for what belongs to a reaction.
const char* const keywords_in_order =
    "!= 3x3 < <= == > >= AGE BIRTH COLUMN COLUMNS ITERATION LAYER LAYERS NEIGHBORS RANDOM ROW ROWS TIME X Y Z "
    "absorbing aggregate always and "
    "anisotropic area as at bicubic bilinear by cell cells centre change channel charges chemical color colormap "
    "columns conc "
    "cotangent create define dev diff direction distribution divide division_limit domain each eta every exit expand "
    "far-field field first fit "
    "five-point fixed floor from gradient gray heat height hex_circle hex_grid icosphere if in inferno level limit "
    "linear "
    "magma map matrix maximum moore move nearest nine-point no-flux none normal offset output packed parameter phase "
    "polarity "
    "polarize probability radius range react repeat rgb rows rule scale seed select set seven-point shape shuffled "
    "sims size slice slot "
    "snap sqr_circle sqr_grid stencil step stop strength stretch striped texture then tile time_step to torus towards "
    "transparent triangular "
    "twenty-seven-point uniform "
    "until use "
    "viridis volume weight weights where width wrap x y z zoom ";

std::set<std::string> keywords() {
    const std::vector<std::string> words = words_of(keywords_in_order);
    std::set<std::string> all{words.begin(), words.end()};
    for (const ModelFacts& model : model_table()) {
        all.insert(model.word);
        for (const ModelParameter& parameter : model.parameters) all.insert(parameter.name);
    }
    return all;
}

// What the parser itself says is allowed where a word of this text is taken out and nonsense put in.
void ask_parser(const std::string& text, const std::filesystem::path& folder, std::set<std::string>& allowed) {
    std::string before;
    for (const std::string& line : lines_of(text)) {
        std::string begun;
        for (const std::string& word : words_of(line)) {
            std::string message;
            try {
                parse_experiment(before + begun + "?", "random.pex", folder);
            } catch (const Error& error) {
                message = error.what();
            }
            const std::string opening = "allowed here: ";
            const std::size_t list = message.find(opening);
            std::string names = list == std::string::npos ? "" : message.substr(list + opening.size());
            names = names.substr(0, names.find(';'));
            std::replace(names.begin(), names.end(), ',', ' ');
            for (const std::string& name : words_of(names)) allowed.insert(name);
            begun += word + " ";
        }
        before += line + "\n";
    }
}

}  // namespace

TEST_CASE("Every drawn text is an experiment whose time step holds") {
    const test::RandomFiles files;
    RandomLimits limits;
    files.offer(limits);
    limits.extremes = false;

    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const std::string text = random_experiment(seed, limits);
        INFO(text);
        const Experiment experiment = parse_experiment(text, "random.pex", files.folder());
        const Snapshot initial = initial_state(experiment);

        CHECK(experiment.last_iteration() <= limits.iterations);
        CHECK(experiment.chemicals.size() <= limits.chemicals);
        CHECK(experiment.rules.size() <= limits.rules);
        CHECK(initial.cells() <= std::max<std::size_t>(limits.cells, 19 * 11));
        CHECK_FALSE(find_instability(experiment, initial).has_value());
    }
}

TEST_CASE("Drawn texts hold every word of the language") {
    const test::RandomFiles files;
    RandomLimits limits;
    files.offer(limits);
    std::set<std::string> drawn;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        for (const std::string& line : lines_of(random_experiment(seed, limits))) {
            for (const std::string& word : words_of(line)) drawn.insert(word);
        }
    }

    for (const std::string& keyword : keywords()) {
        INFO(keyword);
        CHECK(drawn.contains(keyword));
    }
}

TEST_CASE("The list of words is complete as far as the parser tells") {
    const test::RandomFiles files;
    RandomLimits limits;
    files.offer(limits);
    std::set<std::string> allowed;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        ask_parser(random_experiment(seed, limits), files.folder(), allowed);
    }
    for (const char* phrase : {"or", "the", "end", "of", "line"}) allowed.erase(phrase);
    allowed.erase("include");    // it stands for lines, of which drawn texts have enough
    allowed.erase("chemicals");  // several `define chemical` in one
    allowed.erase("5x5");        // what is drawn has nine weights; 25 have cases of their own
    allowed.erase("mesh");       // of a file: meshes that are drawn are made by rule

    const std::set<std::string> known = keywords();
    CHECK(allowed.size() > 100);
    for (const std::string& word : allowed) {
        INFO(word);
        CHECK(known.contains(word));
    }
}

TEST_CASE("Drawn texts are the same on every machine") {
    RandomLimits limits;  // these reactions and no others: a new one changes nothing here
    limits.models = {"turing", "gray-scott", "linear", "gm1", "cubic", "reinforcement"};
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a, 64 bits
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        for (const char letter : random_experiment(seed, limits)) {
            hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
        }
    }

    // To be set anew when what is drawn changes, to what all compilers agree on.
    CHECK(hash == 0x63381ebea5a78e22u);
}

TEST_CASE("Limits bound what is drawn") {
    RandomLimits limits;
    limits.cells = 7;
    limits.iterations = 4;
    limits.chemicals = 1;
    limits.rules = 2;
    limits.sqr_grid = false;
    limits.free_cells = limits.volume = limits.mesh = limits.charges = false;
    limits.phases = false;

    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Experiment experiment = parse_experiment(random_experiment(seed, limits), "random.pex", ".");

        CHECK(count_cells(experiment) <= 7);
        CHECK(experiment.last_iteration() <= 4);
        CHECK(experiment.chemicals.size() == 1);
        CHECK(experiment.rules.size() <= 2);
        CHECK(experiment.phases.size() == 1);
    }
    limits.matrix = false;
    CHECK_THROWS_AS(random_experiment(1, limits), Error);
}

TEST_CASE("A failing text shrinks to the lines that the failure needs") {
    const auto fails = [](const std::string& text) {
        return text.find("b\n") != std::string::npos && text.find("d\n") != std::string::npos;
    };

    CHECK(test::shrunk("a\nb\nc\nd\ne\n", fails) == "b\nd\n");
}
