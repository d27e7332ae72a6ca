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

enum class ExrType { float_, half };  // 32 or 16 bits; a half keeps 3 digits and ends at 65504

struct ExrChannel {
    std::string name;
    std::span<const double> values;  // columns * rows, bottom row first
    ExrType type = ExrType::float_;
};

struct ExrPicture {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::string> names;           // in alphabetical order, as EXR keeps them
    std::vector<std::vector<double>> values;  // [channel][row * columns + column], bottom row first
    Attributes attributes;                    // those of type string
};

// The attribute under which our pictures name the channels that are chemicals, separated by spaces.
inline constexpr const char* exr_chemicals = "pelage:chemicals";

// Losslessly compressed, by several threads where the picture is large; the highest row is the picture's top line.
// Attributes that are not UTF-8 are mended. Throws Error naming the file when it cannot be written, when two channels
// have the same name, or when an attribute's name is one of EXR's own.
void write_exr(const std::filesystem::path&, std::size_t columns, std::size_t rows, const std::vector<ExrChannel>&,
               const Attributes&);

// All channels of a picture in scan lines. Throws Error as read_field does.
ExrPicture read_exr(const std::filesystem::path&);
ExrPicture parse_exr_picture(std::string_view bytes, const std::string& name);  // the same from memory

}  // namespace pelage
