// See names.hpp.
#include "import/names.hpp"

#include "core/functions.hpp"
#include "core/models.hpp"
#include "language/vocabulary.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace pelage::imports {

namespace {

constexpr std::size_t longest_name = 32;

// Words that mean something where a name of a chemical or parameter may stand.
constexpr std::array<std::string_view, 23> words_of_language{
    "if", "and",  "or",   "not",   "PI", "inf",  "infinity", "nan",      "none",      "each",       "packed",    "then",
    "by", "conc", "diff", "scale", "to", "from", "dev",      "previous", "laplacian", "gradient_x", "gradient_y"};

bool is_reserved(const std::string& name) {
    std::string lower = name;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (lower == "inf" || lower == "infinity" || lower == "nan") return true;
    const auto quantities = language::words_of_quantities();
    return std::ranges::find(words_of_language, name) != words_of_language.end() ||
           std::ranges::find(quantities, name) != quantities.end() ||
           std::ranges::find(model_table(), std::string_view(name), &ModelFacts::word) != model_table().end() ||
           std::ranges::find(function_table(), std::string_view(name), &FunctionFacts::name) != function_table().end();
}

std::string with_letters_allowed(std::string_view original) {
    std::string name;
    for (const char c : original.substr(0, longest_name))
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ? c : '_';
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) != 0) name.insert(0, "p_");
    return name.substr(0, longest_name);
}

}  // namespace

std::string NewNames::of(std::string_view original) {
    if (const auto found = names_.find(original); found != names_.end()) return found->second;
    const std::string name = with_letters_allowed(original);
    std::string result = name;
    for (int n = 0; is_reserved(result) || taken_.contains(result); ++n) {
        const std::string ending = n == 0 ? "_" : "_" + std::to_string(n + 1);
        result = name.substr(0, longest_name - ending.size()) + ending;
    }
    taken_.insert(result);
    names_.emplace(original, result);
    return result;
}

bool has_word(std::string_view text, std::string_view name) {
    const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !in_name(text[at - 1])) && (end == text.size() || !in_name(text[end]))) return true;
    }
    return false;
}

bool NewNames::known(std::string_view original) const { return names_.contains(original); }

}  // namespace pelage::imports
