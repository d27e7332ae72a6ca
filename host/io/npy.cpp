// See npy.hpp. Format: numpy.lib.format, versions 1.0 to 3.0.
#include "io/npy.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"
#include "io/npy_header.hpp"
#include "io/number_type.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace pelage {
namespace {

NumberType find_type(const std::string& descr, std::string_view name) {
    static const auto& types =
        *new const std::map<std::string, NumberType, std::less<>>{{"<f2", half_type()},
                                                                  {"<f4", number_type<float>()},
                                                                  {"<f8", number_type<double>()},
                                                                  {"<i2", number_type<std::int16_t>()},
                                                                  {"<i4", number_type<std::int32_t>()},
                                                                  {"<i8", number_type<std::int64_t>()},
                                                                  {"|i1", number_type<std::int8_t>()},
                                                                  {"|u1", number_type<std::uint8_t>()},
                                                                  {"<u2", number_type<std::uint16_t>()},
                                                                  {"<u4", number_type<std::uint32_t>()},
                                                                  {"|b1", number_type<std::uint8_t>()}};
    const auto found = types.find(descr);
    if (found == types.end()) {
        throw Error(
            fmt::format("'{}' holds numbers of type '{}'; allowed are little-endian f2 f4 f8 i1 i2 i4 i8 u1 u2 u4 b1",
                        name, descr));
    }
    return found->second;
}

// Where the header's text lies in the file.
std::string_view header_text(std::string_view bytes, std::string_view name) {
    if (bytes.substr(0, npy_magic.size()) != npy_magic) throw Error(fmt::format("'{}' is not an .npy file", name));
    const auto truncated = [&] { return Error(fmt::format("'{}' is truncated: its .npy header is not whole", name)); };
    if (bytes.size() < 10) throw truncated();
    const int version = static_cast<unsigned char>(bytes[6]);
    if (version < 1 || version > 3) {
        throw Error(fmt::format("'{}' has .npy format version {}; allowed are 1 to 3", name, version));
    }
    const std::size_t start = version == 1 ? 10 : 12;
    if (bytes.size() < start) throw truncated();
    const std::size_t length =
        version == 1 ? load<std::uint16_t>(bytes.data() + 8) : load<std::uint32_t>(bytes.data() + 8);
    if (bytes.size() - start < length) throw truncated();
    return bytes.substr(start, length);
}

std::size_t count_values(const std::vector<std::size_t>& shape, std::string_view name) {
    std::size_t count = 1;
    for (const auto length : shape) {
        if (length != 0 && count > std::numeric_limits<std::size_t>::max() / 16 / length) {
            throw Error(fmt::format("'{}' has the absurd shape ({})", name, fmt::join(shape, ", ")));
        }
        count *= length;
    }
    return count;
}

std::vector<double> transposed(const std::vector<double>& values, std::size_t rows, std::size_t columns) {
    std::vector<double> result(values.size());
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            result[row * columns + column] = values[column * rows + row];
        }
    }
    return result;
}

}  // namespace

bool holds_objects(std::string_view bytes, std::string_view name) {
    return parse_npy_header(header_text(bytes, name), name).descr == "|O";
}

std::string_view npy_content(std::string_view bytes, std::string_view name) {
    const auto text = header_text(bytes, name);
    return bytes.substr(static_cast<std::size_t>(text.data() - bytes.data()) + text.size());
}

NpyArray parse_npy(std::string_view bytes, std::string_view name) {
    const auto text = header_text(bytes, name);
    const auto header = parse_npy_header(text, name);
    const auto type = find_type(header.descr, name);
    const auto count = count_values(header.shape, name);
    const auto data = npy_content(bytes, name);
    if (data.size() != count * type.size) {
        throw Error(fmt::format("'{}' is {}: {} bytes of numbers where its shape ({}) needs {}", name,
                                data.size() < count * type.size ? "truncated" : "too long", data.size(),
                                fmt::join(header.shape, ", "), count * type.size));
    }
    NpyArray array{header.shape, std::vector<double>(count)};
    for (std::size_t i = 0; i < count; ++i) array.values[i] = type.load(data.data() + i * type.size);
    if (!header.fortran_order || header.shape.size() < 2) return array;
    if (header.shape.size() > 2) {
        throw Error(fmt::format("'{}' is in Fortran order with {} dimensions; at most 2 are allowed so", name,
                                header.shape.size()));
    }
    array.values = transposed(array.values, header.shape[0], header.shape[1]);
    return array;
}

NpyArray read_npy(const std::filesystem::path& path) { return parse_npy(read_file(path), path.string()); }

std::string npy_bytes(const std::vector<std::size_t>& shape, std::span<const double> values, NpyType type,
                      std::string_view name) {
    if (count_values(shape, name) != values.size()) {
        throw Error(fmt::format("'{}' cannot be written: {} values do not fill the shape ({})", name, values.size(),
                                fmt::join(shape, ", ")));
    }
    const bool single = type == NpyType::float32;
    auto header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}{}), }}", single ? "<f4" : "<f8",
                              fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
    header.append(63 - (10 + header.size()) % 64, ' ');  // numbers start at a multiple of 64
    header += '\n';

    std::string bytes(npy_magic);
    bytes += {1, 0, static_cast<char>(header.size() & 0xff), static_cast<char>(header.size() >> 8)};
    bytes += header;
    const auto add = [&bytes](const auto& numbers) {
        bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof numbers[0]);
    };
    if (single)
        add(std::vector<float>(values.begin(), values.end()));
    else
        add(values);
    return bytes;
}

void write_npy(const std::filesystem::path& path, const std::vector<std::size_t>& shape, std::span<const double> values,
               NpyType type) {
    write_file(path, npy_bytes(shape, values, type, path.string()));
}

}  // namespace pelage
