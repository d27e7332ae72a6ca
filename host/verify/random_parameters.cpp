// Some numbers of a random experiment by name: `define parameter`.
#include "language/cursor.hpp"
#include "verify/random_draft.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace pelage::verify {

namespace {

struct Written {  // a number in the text
    std::size_t begin = 0;
    std::size_t end = 0;
};

bool blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// Outside of quotes and remarks.
std::vector<Written> numbers_of(const std::string& text) {
    std::vector<Written> found;
    bool quoted = false;
    bool remark = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') quoted = remark = false;
        if (text[i] == '"') quoted = !quoted;
        if (!quoted && text.compare(i, 2, "//") == 0) remark = true;
        if (quoted || remark || blank(text[i]) || text[i] == '"') continue;
        const std::size_t begin = i;
        while (i < text.size() && !blank(text[i]) && text[i] != '"' && text.compare(i, 2, "//") != 0) ++i;
        const auto value = language::to_number(text.substr(begin, i - begin));
        if (value && std::fabs(*value) <= language::largest_whole) found.push_back({begin, i});
        --i;
    }
    return found;
}

}  // namespace

void name_numbers(Draft& draft) {
    const std::vector<Written> numbers = numbers_of(draft.text);
    if (numbers.empty() || !draft.dice.chance(40)) return;
    std::string definitions;
    std::size_t named = 0;
    // From the last one on, so that no place moves.
    for (auto one = numbers.rbegin(); one != numbers.rend() && named < 6; ++one) {
        if (!draft.dice.chance(12)) continue;
        const std::string name = fmt::format("number-{}", named++);
        const std::string value = draft.text.substr(one->begin, one->end - one->begin);
        const char* const meaning = draft.dice.chance(50) ? " \"drawn\"" : "";
        const std::string range = draft.dice.chance(50) ? fmt::format(" from {0} to {0}", value) : "";
        definitions += fmt::format("define parameter {} {}{}{}\n", name, value, range, meaning);
        draft.text.replace(one->begin, one->end - one->begin, name);
    }
    const std::size_t first_line = draft.text.find('\n') + 1;  // a remark
    draft.text.insert(first_line, definitions);
}

}  // namespace pelage::verify
