// See read_experiment.hpp.
#include "app/read_experiment.hpp"

#include "app/say.hpp"
#include "core/error.hpp"
#include "language/include.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

namespace pelage::app {

namespace {

std::string text_of_standard_input() {
    std::string text;
    std::array<char, 1 << 16> part{};
    while (text.size() <= largest_text && (std::cin.read(part.data(), part.size()), std::cin.gcount() > 0)) {
        text.append(part.data(), static_cast<std::size_t>(std::cin.gcount()));
    }
    return text;
}

// Whether a line of the text begins with this word.
bool has_statement(const std::string& text, std::string_view word) {
    std::istringstream lines(text);
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        if (std::istringstream(line) >> first && first == word) return true;
    }
    return false;
}

// Files that others include fail by themselves for want of what stands before and behind them there.
bool may_be_part(const std::string& text, std::string_view fault) {
    return !text.empty() && !has_statement(text, "create") && !has_statement(text, "include") &&
           fault.find("did you mean 'create'") == std::string_view::npos;
}

}  // namespace

std::string experiment_text(const std::filesystem::path& file) {
    return file == standard_input ? text_of_standard_input() : language::read_text(file);
}

Experiment experiment_of(const std::string& text, const std::filesystem::path& file, StartPictures pictures,
                         const std::vector<Setting>& settings, Outline* outline) {
    if (file == standard_input) return parse_experiment(text, "standard input", ".", outline, pictures, settings);
    return parse_experiment(text, file.string(), file.parent_path(), outline, pictures, settings);
}

Experiment read_experiment(const std::filesystem::path& file, Outline* outline, StartPictures pictures,
                           const std::vector<Setting>& settings) {
    const std::string text = experiment_text(file);
    try {
        return experiment_of(text, file, pictures, settings, outline);
    } catch (const Error& error) {
        if (!may_be_part(text, error.what())) throw;
        throw Error(fmt::format(
            "{} (this file has no 'create ...'; if it is a part that others include, give an experiment that does)",
            error.what()));
    }
}

void print_warnings(const Experiment& experiment, const std::vector<Warning>& warnings) {
    for (const Warning& warning : warnings) say(stderr, "pelage: {}\n", shown(experiment, warning));
}

}  // namespace pelage::app
