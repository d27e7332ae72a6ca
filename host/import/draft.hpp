// An experiment that is being made of another program's file, and its text.
#pragma once

#include "import/term.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pelage::imports {

struct DraftChemical {
    std::string name;
    TermRef start = number_term(0.0);
    TermRef rate = number_term(0.0);  // of diffusion, in cells squared a unit of time
    std::vector<double> picture;      // columns * rows values, the bottom row first; empty: `start` holds
};

struct DraftParameter {
    std::string name;
    TermRef value;
    std::optional<std::pair<double, double>> range;
};

struct DraftStencil {  // with a name
    std::string name;
    std::vector<std::string> weights;  // 9, 25 or 49, the upper row first, as the language writes them
};

struct Draft {
    std::vector<std::string> heading;        // comments at the top
    std::vector<DraftParameter> parameters;  // each after those it is made of
    std::vector<DraftChemical> chemicals;
    TermRef time_step = number_term(1.0);
    std::string stencil = "nine-point";
    std::vector<DraftStencil> stencils;
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::string edge = "wrap";
    std::vector<std::string> starts;  // lines behind `create matrix`
    std::vector<std::string> rules;
    std::vector<std::string> outputs;
    std::size_t last_iteration = 10'000;
};

inline constexpr std::size_t most_cells = std::size_t{1} << 26;  // of an imported lattice

// `base` is how the names of pictures begin: "spots" makes "spots.a.npy".
std::string picture_name(const Draft&, const DraftChemical&, const std::string& base);
std::string text_of(const Draft&, const std::string& base, const std::vector<std::string>& notes);

}  // namespace pelage::imports
