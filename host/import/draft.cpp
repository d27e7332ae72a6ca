// See draft.hpp.
#include "import/draft.hpp"

#include "language/vocabulary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pelage::imports {

namespace {

// A value where a number may stand.
std::string as_value(const TermRef& term) {
    const auto words = language::words_of_quantities();
    const bool word = is_name(term) && (term->text == "PI" || std::ranges::find(words, term->text) != words.end());
    if (is_leaf_number(term) || (is_name(term) && !word)) return text_of(term);
    if (term->text == "negate" && is_leaf_number(term->arguments[0])) return text_of(term);
    return "(" + text_of(term) + ")";
}

std::string as_comment(std::string_view text) {
    std::string lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines += fmt::format("// {}\n", text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

std::string parameter_lines(const Draft& draft) {
    std::string lines;
    for (const DraftParameter& one : draft.parameters) {
        lines += fmt::format("define parameter {} {}", one.name, as_value(one.value));
        if (one.range)
            lines += fmt::format(" from {} to {}", number_text(one.range->first), number_text(one.range->second));
        lines += '\n';
    }
    return lines;
}

std::string chemical_lines(const Draft& draft, const std::string& base) {
    std::string lines;
    for (const DraftChemical& one : draft.chemicals) {
        lines += fmt::format("define chemical {} floor none", one.name);
        if (!one.picture.empty()) lines += fmt::format(" conc \"{}\"", picture_name(draft, one, base));
        lines += '\n';
    }
    return lines;
}

std::string use_lines(const Draft& draft) {
    std::string lines;
    for (const DraftChemical& one : draft.chemicals) {
        std::string options;
        if (one.picture.empty()) options += " conc " + as_value(one.start);
        if (!is_number(one.rate, 0.0)) options += " diff " + as_value(one.rate);
        if (!options.empty()) lines += fmt::format("use chemical {}{}\n", one.name, options);
    }
    return lines;
}

std::string all_of(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

std::string stencil_lines(const Draft& draft) {
    std::string lines;
    for (const DraftStencil& one : draft.stencils) {
        const int side = one.weights.size() == 9 ? 3 : one.weights.size() == 25 ? 5 : 7;
        lines += fmt::format("define stencil {0} {1}x{1} {2}\n", one.name, side, fmt::join(one.weights, " "));
    }
    return lines;
}

}  // namespace

std::string picture_name(const Draft&, const DraftChemical& chemical, const std::string& base) {
    return fmt::format("{}.{}.npy", base, chemical.name);
}

std::string text_of(const Draft& draft, const std::string& base, const std::vector<std::string>& notes) {
    std::string text;
    for (const std::string& line : draft.heading) text += as_comment(line);
    for (const std::string& note : notes) text += as_comment("NOTE: " + note);
    text += '\n' + parameter_lines(draft) + (draft.parameters.empty() ? "" : "\n");
    text += chemical_lines(draft, base);
    text += fmt::format("define time_step {}\ndefine stencil {}\n", as_value(draft.time_step), draft.stencil);
    text += stencil_lines(draft) + '\n';
    text += use_lines(draft);
    text += fmt::format("create matrix {} {} {}\n", draft.columns, draft.rows, draft.edge);
    text += all_of(draft.starts) + '\n' + all_of(draft.rules) + '\n';
    text += fmt::format("stop at {}\n", draft.last_iteration);
    return text + all_of(draft.outputs);
}

}  // namespace pelage::imports
