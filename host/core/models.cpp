// See models.hpp.
#include "core/models.hpp"

#include "core/error.hpp"
#include "core/model_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <locale>
#include <optional>
#include <set>
#include <sstream>

namespace pelage {

namespace {

// "a, b" has two parts, "a," too: the last one is then empty.
std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

bool blank(const std::string& text) { return text.find_first_not_of(' ') == std::string::npos; }

// Species are parts of the names of functions, parameters are words of the language.
bool is_name(const std::string& text) {
    const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const auto fits = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !text.empty() && letter(text.front()) && std::ranges::all_of(text, fits);
}

struct Interval {
    std::string name;
    double low = 0.0;
    double high = 0.0;
    bool kept = false;
};

// "v 0 to 1 kept"
std::optional<Interval> read_interval(const std::string& text) {
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    Interval found;
    std::string to;
    std::string last;
    if (!(words >> found.name >> found.low >> to >> found.high) || to != "to" || !(found.low < found.high)) return {};
    if (words >> last) found.kept = true;
    if (found.kept && (last != "kept" || words >> last)) return {};
    if (!is_name(found.name)) return {};
    return found;
}

std::string file_of(std::string word) {
    std::ranges::replace(word, '-', '_');
    return word;
}

class Declaration {
public:
    Declaration(const std::string& file, const std::string& text) : file_(file), text_(text) {}

    ModelFacts read() {
        const std::vector<std::string> parts = split(text_, '|');
        if (parts.size() != 3) fail("a declaration has three parts, 'model WORD | SPECIES ... | PARAMETERS ...'");
        read_word(parts[0]);
        for (const std::string& text : split(parts[1], ',')) read_species(text);
        if (facts_.changed() == 0) fail("a reaction changes at least one species");
        if (blank(parts[2])) return facts_;
        for (const std::string& text : split(parts[2], ',')) read_parameter(text);
        return facts_;
    }

private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(fmt::format("kernels/models/{}.cl:1: {}; found '//@ {}'", file_, why, text_));
    }

    void read_word(const std::string& text) {
        std::istringstream words(text);
        std::string model;
        std::string more;
        words >> model >> facts_.word;
        if (model != "model" || words >> more || file_of(facts_.word) != file_)
            fail(fmt::format("the line of this file begins with 'model {}'", spoken()));
        if (facts_.word == "scale") fail("'scale' is a word of every reaction");
    }

    std::string spoken() const {
        std::string word = file_;
        std::ranges::replace(word, '_', '-');
        return word;
    }

    void read_species(const std::string& text) {
        const auto found = read_interval(text);
        if (!found) fail(fmt::format("a species is 'NAME LOW to HIGH [kept]', not '{}'", text));
        if (!facts_.species.empty() && facts_.species.back().kept && !found->kept) fail("kept species stand last");
        check_new(found->name);
        facts_.species.push_back({found->name, found->low, found->high, found->kept});
    }

    void read_parameter(const std::string& text) {
        const auto found = read_interval(text);
        if (!found || found->kept) fail(fmt::format("a parameter is 'NAME LOW to HIGH', not '{}'", text));
        check_new(found->name);
        facts_.parameters.push_back({found->name, found->low, found->high});
    }

    void check_new(const std::string& name) {
        if (!names_.insert(name).second) fail(fmt::format("the name '{}' stands twice", name));
    }

    const std::string& file_;
    const std::string& text_;
    ModelFacts facts_;
    std::set<std::string> names_;
};

}  // namespace

std::size_t ModelFacts::changed() const {
    return static_cast<std::size_t>(std::ranges::count(species, false, &ModelSpecies::kept));
}

ModelFacts read_model(const std::string& file, const std::string& declaration) {
    return Declaration(file, declaration).read();
}

const std::vector<ModelFacts>& model_table() {
    static const auto& table = *new const std::vector<ModelFacts>([] {
        std::vector<ModelFacts> read;
        for (const ModelLine& line : model_lines()) read.push_back(read_model(line.file, line.text));
        return read;
    }());
    return table;
}

Model model_named(std::string_view word) {
    const auto& table = model_table();
    const auto found = std::ranges::find(table, word, &ModelFacts::word);
    if (found != table.end()) return {static_cast<std::size_t>(found - table.begin())};
    std::vector<std::string> words;
    for (const ModelFacts& facts : table) words.push_back(facts.word);
    throw Error(fmt::format("there is no reaction '{}'; there are: {}", word, fmt::join(words, ", ")));
}

}  // namespace pelage
