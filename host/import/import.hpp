// Experiments made of other programs' files: patterns of Ready and presets of VisualPDE.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pelage::imports {

struct Import {
    std::string text;                // of the experiment
    std::vector<std::string> notes;  // what is left out or done differently
    struct Picture {
        std::string name;  // beside the experiment
        std::vector<double> values;
    };
    std::vector<Picture> pictures;  // chemicals at the start, the bottom row first
    std::size_t columns = 0;
    std::size_t rows = 0;
};

// `name` is for messages, `base` is how the pictures' names begin. What comes back has been read by the parser of
// experiments. Throws Error, a line for each construct that cannot be carried over.
Import import_text(std::string bytes, const std::string& name, const std::string& base);

// Pictures first, then the experiment, each whole or not at all. Throws Error where one cannot be written; then none is
// left.
void write_import(const Import&, const std::filesystem::path& experiment);

}  // namespace pelage::imports
