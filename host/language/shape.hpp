// Shape files: a drawing in which each letter is a cell.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pelage::language {

inline constexpr std::size_t largest_shape = 64u << 20;  // bytes

// The file's lines, top one first, without line ends. Throws Error when it cannot be read, is too large or has no
// letter.
std::vector<std::string> read_shape(const std::filesystem::path&);

// The two halves of that.
std::string read_shape_text(const std::filesystem::path&);
std::vector<std::string> shape_lines(const std::string& text, const std::filesystem::path&);

std::size_t count_letters(const std::vector<std::string>& lines);

}  // namespace pelage::language
