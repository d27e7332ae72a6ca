// What the values of options may look like, beside what CLI11 has for it. None adds a text of its own to --help.
#pragma once

#include <CLI/App.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pelage::app {

// A whole number in one of the usual ways of writing it (1000, 1e3, +7), brought to plain digits.
CLI::Validator whole_number(std::int64_t smallest, std::uint64_t largest, std::uint64_t multiple_of = 1);

CLI::Validator one_of(const std::vector<std::string>& words);

CLI::Validator number(double least, double most);

// "; did you mean 'WORD'?" of the word that is nearest, or nothing.
std::string meant(const std::string& found, const std::vector<std::string>& words);

// Blanks around the value do not count: "png, npy".
CLI::Validator trimmed();

}  // namespace pelage::app
