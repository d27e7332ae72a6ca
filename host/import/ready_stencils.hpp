// The stencils that Ready's formulas have keywords for, and its names of single cells around.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace pelage::imports {

struct ReadyStencil {
    std::vector<int> weights;  // 9, 25 or 49, the upper row first
    int divisor = 1;
    int powers_of_dx = 0;
};

// Of "bilaplacian", "sobelN", ...; empty where that is no such keyword. Those that the language has words for, the
// Laplacian and the gradients, are among them.
std::optional<ReadyStencil> ready_stencil(std::string_view keyword, bool one_dimensional);

struct ReadyOffset {
    int right = 0;
    int up = 0;
};

// Of "n", "se2", "n2w", ...; empty where these are no such directions.
std::optional<ReadyOffset> ready_offset(std::string_view directions);

// One cell, up to three away; empty of one further. Along a dimension that the image has not, each cell lies beside
// itself.
std::optional<ReadyStencil> ready_cell(ReadyOffset, bool one_dimensional);

}  // namespace pelage::imports
