// One output of a lattice, or of a texture, as a PNG picture.
#pragma once

#include "core/experiment.hpp"
#include "io/colour.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace pelage {

struct Surface {
    std::vector<std::span<const double>> values;  // one of columns * rows, bottom row first, or red, green and blue
    std::size_t columns = 0;
    std::size_t rows = 0;
    double width = 1.0;  // of an element, in cells
    double height = 1.0;
    bool wrap = false;
    std::size_t factor = 1;  // coloured pictures are enlarged by; maps never are
};

// The range in which an output draws: its own, else `shared`, else the values'.
ValueRange drawn_range(const Output&, std::span<const double> values, const std::optional<ValueRange>& shared);

// `deep`: colours and normals have 16 bits a channel, as heights always have. Throws Error naming the file.
void write_output(const std::filesystem::path&, const Surface&, const Output&, const std::optional<ValueRange>& shared,
                  bool deep);

}  // namespace pelage
