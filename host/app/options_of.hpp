// The options of a command as the manual and the shells' completions want them, read from its definition.
#pragma once

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace pelage::app {

struct OptionText {
    std::vector<std::string> names;  // "-o", "--out"; empty: a word that is no option (FILE)
    std::string value;               // what follows it: "N", "float|double"; empty: nothing
    std::string text;
    std::vector<std::string> words;  // the values to choose from; empty: any

    bool takes_file() const { return value == "FILE" || value == "DIR" || value == "CHECKPOINT"; }
};

// All but hidden ones, words that are no option last.
std::vector<OptionText> options_of(const CLI::App&);

// The names of those that are options: "-o", "--out", ...
std::vector<std::string> option_names(const CLI::App&);

}  // namespace pelage::app
