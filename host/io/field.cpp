// See field.hpp.
#include "io/field.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "io/npy.hpp"

#include <fmt/format.h>
#include <cmath>
#include <utility>

namespace pelage {
namespace {

constexpr std::string_view png_magic{"\x89PNG\r\n\x1a\n", 8};
constexpr std::string_view exr_magic{"\x76\x2f\x31\x01", 4};

// No compression of PNG or EXR gains more than this in practice (deflate: 1032).
constexpr std::size_t largest_gain = 4096;

Field field_of(NpyArray array, const std::string& channel, const std::string& name) {
    if (!channel.empty()) {
        throw Error(fmt::format("'{}' is an array and has no channel '{}'; leave the channel out", name, channel));
    }
    if (array.shape.size() != 2) {
        throw Error(fmt::format("'{}' has {}; a field has 2", name, counted(array.shape.size(), "dimension")));
    }
    check_picture_size(array.shape[1], array.shape[0], array.values.size(), array.values.size(), name);
    return {array.shape[1], array.shape[0], std::move(array.values)};
}

void check_finite(const Field& field, const std::string& name) {
    for (std::size_t i = 0; i < field.values.size(); ++i) {
        if (std::isfinite(field.values[i])) continue;
        throw Error(fmt::format("'{}' holds {} at row {}, column {}; a field must be finite", name, field.values[i],
                                i / field.columns, i % field.columns));
    }
}

}  // namespace

void check_picture_size(std::size_t columns, std::size_t rows, std::size_t raw_size, std::size_t file_size,
                        const std::string& name) {
    if (columns == 0 || rows == 0) throw Error(fmt::format("'{}' holds no cells: {} x {}", name, columns, rows));
    if (columns > largest_cell_count / rows) {
        throw Error(
            fmt::format("'{}' is {} x {}; at most {} cells are allowed", name, columns, rows, largest_cell_count));
    }
    if (raw_size / largest_gain > file_size) {
        throw Error(fmt::format("'{}' is corrupted: it says {} x {} but has only {}", name, columns, rows,
                                counted(file_size, "byte")));
    }
}

double luminance(double red, double green, double blue) {
    if (red == green && green == blue) return red;
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

Field parse_field(std::string_view bytes, const std::string& channel, const std::string& name) {
    Field field;
    if (bytes.starts_with(png_magic))
        field = parse_png(bytes, channel, name);
    else if (bytes.starts_with(exr_magic))
        field = parse_exr(bytes, channel, name);
    else if (bytes.starts_with(npy_magic))
        field = field_of(parse_npy(bytes, name), channel, name);
    else
        throw Error(fmt::format("'{}' is neither a PNG nor an EXR picture nor an .npy array", name));
    check_finite(field, name);
    return field;
}

std::shared_ptr<const Field> read_field(const std::filesystem::path& path, const std::string& channel) {
    return std::make_shared<const Field>(parse_field(read_file(path), channel, path.string()));
}

}  // namespace pelage
