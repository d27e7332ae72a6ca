// The head of a PLY file: which elements of which properties follow, in which form.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

inline bool is_whole(PlyType type) { return type < PlyType::float32; }
std::size_t ply_size(PlyType);  // bytes in binary data

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count;  // of a list: the type of its length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    std::optional<std::size_t> property(std::string_view name) const;
    std::size_t least_bytes(bool ascii) const;  // that one takes, its lists being empty
};

enum class PlyForm { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyForm form = PlyForm::ascii;
    std::vector<PlyElement> elements;
    std::size_t lines = 0;
    std::size_t bytes = 0;
};

// Throws Error with `name` and line. An element of no properties, more elements or properties than a hundred and counts
// that the file cannot hold are refused.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace pelage
