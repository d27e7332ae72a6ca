// The table of reactions: their words, species and parameters, as the first lines of kernels/models/*.cl state them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

struct ModelSpecies {
    std::string name;  // in the formulas
    double low = 0.0;  // between these the reaction does something worth seeing
    double high = 1.0;
    bool kept = false;  // read but not changed; kept species stand last
};

struct ModelParameter {
    std::string name;  // as written in the language
    double low = 0.0;  // sensible values lie between these
    double high = 1.0;
};

struct ModelFacts {
    std::string word;  // as written in the language: "gray-scott"
    std::vector<ModelSpecies> species;
    std::vector<ModelParameter> parameters;

    std::size_t changed() const;  // how many species the reaction changes: the first ones
};

// Throws Error when a declaration cannot be understood; `file` is the kernel file's name without folder and ending.
ModelFacts read_model(const std::string& file, const std::string& declaration);

// Every reaction there is, in order of file names.
const std::vector<ModelFacts>& model_table();

// One reaction of the table.
struct Model {
    std::size_t index = 0;

    const ModelFacts& facts() const { return model_table()[index]; }
    bool operator==(const Model&) const = default;
};

// Throws Error naming those there are.
Model model_named(std::string_view word);

}  // namespace pelage
