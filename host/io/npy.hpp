// NumPy's array files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

inline constexpr std::string_view npy_magic{"\x93NUMPY", 6};  // how such a file begins

struct NpyArray {
    std::vector<std::size_t> shape;  // empty: one number
    std::vector<double> values;      // row-major (C order), whatever the order in the file
};

// Little-endian float16/32/64, signed int8..64, unsigned int8..32 and bool; Fortran order in up to two dimensions.
// int64 beyond 2^53 is rounded. Throws Error naming the file on anything else, and on truncated or overlong files.
NpyArray read_npy(const std::filesystem::path&);
NpyArray parse_npy(std::string_view bytes, std::string_view name);  // the same from memory

// Of such a file: whether it holds Python objects, and what follows the header.
bool holds_objects(std::string_view bytes, std::string_view name);
std::string_view npy_content(std::string_view bytes, std::string_view name);

enum class NpyType { float32, float64 };

// Such a file's bytes: format version 1.0, C order. Throws Error when the shape does not fit the values.
std::string npy_bytes(const std::vector<std::size_t>& shape, std::span<const double> values, NpyType,
                      std::string_view name);

// The same as a file. Throws Error when the shape does not fit the values or the file cannot be written.
void write_npy(const std::filesystem::path&, const std::vector<std::size_t>& shape, std::span<const double> values,
               NpyType = NpyType::float64);

}  // namespace pelage
