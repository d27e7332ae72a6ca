// The colour of each cell in one picture.
#pragma once

#include "io/colour.hpp"
#include "io/picture.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pelage {

// Values through the output's colormap; or red, green and blue, from 0 (none) to 1 (full), what lies outside being cut.
// A NaN is magenta.
class Brush {
public:
    // `columns`: values of all cells or texels, one column or three, which must live longer. The range is the output's
    // own, else `found`.
    Brush(const Output&, std::vector<std::span<const double>> columns, const ValueRange& found);

    std::size_t cells() const { return columns_.front().size(); }
    Rgb operator()(std::size_t cell) const;
    DeepRgb deep(std::size_t cell) const;  // 16 bits a channel

private:
    std::vector<std::span<const double>> columns_;
    std::optional<Colours> colours_;
};

// One pixel a value; the values have the bottom row first, the picture the top line.
Picture render(const Brush&, std::size_t columns, std::size_t rows);
DeepPicture render_deep(const Brush&, std::size_t columns, std::size_t rows);

// One column of values, in their own range or the output's.
Picture render(std::span<const double> values, std::size_t columns, std::size_t rows, const Output&);

}  // namespace pelage
