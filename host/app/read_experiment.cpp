// See read_experiment.hpp.
#include "app/read_experiment.hpp"

#include "app/say.hpp"

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

Experiment read_experiment(const std::filesystem::path& file, Outline* outline, StartPictures pictures,
                           const std::vector<Setting>& settings) {
    if (file != standard_input) return parse_experiment_file(file, outline, pictures, settings);
    return parse_experiment(text_of_standard_input(), "standard input", ".", outline, pictures, settings);
}

void print_warnings(const Experiment& experiment, const std::vector<Warning>& warnings) {
    for (const Warning& warning : warnings) say(stderr, "pelage: {}\n", shown(experiment, warning));
}

}  // namespace pelage::app
