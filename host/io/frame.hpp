// Pictures as the frames of a film: all of one size, in the form that programs for films take.
#pragma once

#include "io/picture.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace pelage {

// How many pixels become one, or one becomes how many: `to` stand for `from`.
struct Scale {
    std::size_t to = 1;
    std::size_t from = 1;

    std::size_t of(std::size_t length) const;  // at least 1
};

// The largest scale at which so many columns and rows fit into a frame.
Scale fitting_scale(std::size_t columns, std::size_t rows, std::size_t frame_columns, std::size_t frame_rows);

// The picture in the middle of a white frame. Enlarged, every pixel keeps its colour (nearest neighbour); reduced,
// pixels take the mean of those they stand for. What does not fit is cut off.
Picture framed(const Picture&, const Scale&, std::size_t frame_columns, std::size_t frame_rows);

// A colour in a word of three parts (see frame_loops.hpp): red, green and blue, or brightness (16 to 235) and colour
// differences (16 to 240) by ITU-R BT.709.
std::uint32_t parts_word(const Rgb&);
std::uint32_t yuv_word(const Rgb&);

// Such words as three planes, as ffmpeg's yuv420p wants them: of the differences the mean of every 2 x 2 pixels.
// Columns and rows must be even; `to` keeps its memory from call to call.
class Yuv420 {
public:
    Yuv420(std::size_t columns, std::size_t rows, std::string& to);

    void put(std::size_t line, const std::uint32_t* above,
             const std::uint32_t* below);  // two lines, from an even one on

private:
    std::size_t columns_;
    std::uint8_t* bright_;
    std::uint8_t* blue_;
    std::uint8_t* red_;
};

void write_yuv420(const Picture&, std::string& to);

}  // namespace pelage
