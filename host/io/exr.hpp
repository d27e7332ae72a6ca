// EXR pictures of a lattice: what a run's concentrations look like to other programs, without loss in float.
#pragma once

#include "io/attributes.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

struct ExrChannel {
    std::string name;
    std::span<const double> values;  // columns * rows, bottom row first
};

struct ExrPicture {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::string> names;           // in alphabetical order, as EXR keeps them
    std::vector<std::vector<double>> values;  // [channel][row * columns + column], bottom row first
    Attributes attributes;                    // those of type string
};

// One 32-bit FLOAT channel each, losslessly compressed; the highest row is the picture's top line. Throws Error naming
// the file when it cannot be written, when two channels have the same name, or when an attribute's name is one of EXR's
// own.
void write_exr(const std::filesystem::path&, std::size_t columns, std::size_t rows, const std::vector<ExrChannel>&,
               const Attributes&);

// All channels of a picture in scan lines. Throws Error as read_field does.
ExrPicture read_exr(const std::filesystem::path&);
ExrPicture parse_exr_picture(std::string_view bytes, const std::string& name);  // the same from memory

}  // namespace pelage
