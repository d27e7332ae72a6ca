// See read_experiment.hpp.
#include "app/read_experiment.hpp"

#include "app/say.hpp"
#include "language/include.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <iostream>

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
    return experiment_of(experiment_text(file), file, pictures, settings, outline);
}

void print_warnings(const Experiment& experiment, const std::vector<Warning>& warnings) {
    for (const Warning& warning : warnings) say(stderr, "pelage: {}\n", shown(experiment, warning));
}

}  // namespace pelage::app
