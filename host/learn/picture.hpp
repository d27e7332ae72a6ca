// The picture that is learned, and windows of it: turned, and with as many pixels as the torus has cells.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::learn {

struct Colours {
    std::size_t columns = 0, rows = 0;
    std::array<std::vector<double>, 3> values;  // red, green, blue, from 0 to 1; the lowest row first
};

// A PNG picture; alpha is left out of account. Throws Error naming the file where it is none, or has fewer than 7
// pixels in a row or a column.
Colours read_colours(const std::filesystem::path&);
Colours parse_colours(std::string_view bytes, const std::string& name);  // the same from memory

struct Window {
    std::size_t side = 0;
    std::array<std::vector<double>, 3> values;
    std::vector<bool> inside;  // pixels that lie within the picture
};

// Around the middle of the picture, `scale` pixels of which become one in each direction, turned by `angle` radians.
// Beyond its edges the picture goes on from the other side where it wraps, else there is nothing.
Window window_of(const Colours&, std::size_t side, double scale, double angle, bool wrap);

Window halved(const Window&);

}  // namespace pelage::learn
