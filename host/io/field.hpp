// Pictures and arrays as the initial state of a chemical.
#pragma once

#include "core/experiment.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace pelage {

// Reads, told apart by their first bytes:
//   PNG   1 to 16 bits, any colour type, scaled to 0..1; `channel` is R, G, B (the same in shades of grey), A where the
//         picture has it, or empty for luminance, which leaves alpha out of account
//   EXR   scan lines; `channel` is a channel's name; empty: see exr_channels.hpp
//   .npy  two dimensions; `channel` must be empty
// A picture's lowest line becomes row 0; row 0 of an array stays row 0. Throws Error naming the file when it is not
// there, corrupted, holds a NaN or infinity, no such channel, no cell or more than largest_cell_count.
std::shared_ptr<const Field> read_field(const std::filesystem::path&, const std::string& channel);
Field parse_field(std::string_view bytes, const std::string& channel, const std::string& name);  // the same from memory

// Of one kind, whose numbers may be NaN or infinite; `name` is for messages.
Field parse_png(std::string_view bytes, const std::string& channel, const std::string& name);
Field parse_exr(std::string_view bytes, const std::string& channel, const std::string& name);

// 0.2126 R + 0.7152 G + 0.0722 B (Rec. 709), exactly the grey value where all three are equal.
double luminance(double red, double green, double blue);

// Throws Error when a field of this size is not allowed, or when the file, of `file_size` bytes, is too short to hold
// the `raw_size` bytes that its pixels have before compression.
void check_picture_size(std::size_t columns, std::size_t rows, std::size_t raw_size, std::size_t file_size,
                        const std::string& name);

}  // namespace pelage
