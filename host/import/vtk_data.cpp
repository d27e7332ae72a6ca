// See vtk_data.hpp. Layouts are those of VTK's documentation of its XML formats.
#include "import/vtk_data.hpp"

#include "core/error.hpp"
#include "import/base64.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

namespace pelage::imports {

namespace {

struct VtkType {
    std::string_view name;
    std::size_t size;
    double (*read)(const char*);
};

template <class T>
double read_as(const char* from) {
    return static_cast<double>(load<T>(from));
}

constexpr std::array<VtkType, 10> vtk_types{{{"Float32", 4, read_as<float>},
                                             {"Float64", 8, read_as<double>},
                                             {"Int8", 1, read_as<std::int8_t>},
                                             {"UInt8", 1, read_as<std::uint8_t>},
                                             {"Int16", 2, read_as<std::int16_t>},
                                             {"UInt16", 2, read_as<std::uint16_t>},
                                             {"Int32", 4, read_as<std::int32_t>},
                                             {"UInt32", 4, read_as<std::uint32_t>},
                                             {"Int64", 8, read_as<std::int64_t>},
                                             {"UInt64", 8, read_as<std::uint64_t>}}};

class VtkReader {
public:
    VtkReader(const XmlDocument& document, const XmlElement& array) : document_(document), array_(array) {
        const std::string* header = document.root.attribute("header_type");
        const std::string* order = document.root.attribute("byte_order");
        word_ = header != nullptr && *header == "UInt64" ? 8 : 4;
        swapped_ = order != nullptr && *order == "BigEndian";
        const std::string* compressor = document.root.attribute("compressor");
        compressed_ = compressor != nullptr && !compressor->empty();
        if (compressed_ && *compressor != "vtkZLibDataCompressor")
            fail(fmt::format("the data are compressed by '{}'; vtkZLibDataCompressor can be read", *compressor));
    }

    std::vector<double> read(std::size_t count) {
        const std::string* format = array_.attribute("format");
        if (format == nullptr || *format == "ascii") return from_text(count);
        const VtkType type = type_of_array();
        const std::size_t wanted = count * type.size;
        std::string bytes;
        if (*format == "binary")
            bytes = decoded(array_.text, true, wanted);
        else if (*format == "appended")
            bytes = decoded(appended_part(), !document_.appended_raw, wanted);
        else
            fail(fmt::format("format '{}' is not ascii, binary or appended", *format));
        return to_numbers(bytes, type, count);
    }

private:
    [[noreturn]] void fail(std::string_view what) const {
        throw Error(fmt::format("{}: {}", document_.at(array_), what));
    }

    VtkType type_of_array() const {
        const std::string* name = array_.attribute("type");
        const auto* const found =
            name == nullptr ? vtk_types.end() : std::ranges::find(vtk_types, *name, &VtkType::name);
        if (found == vtk_types.end())
            fail(fmt::format("data of type '{}' cannot be read", name == nullptr ? "" : *name));
        return *found;
    }

    std::vector<double> from_text(std::size_t count) const {
        if (array_.text.size() / 2 + 1 < count) too_few(count);
        std::vector<double> values;
        values.reserve(count);
        const char* at = array_.text.data();
        const char* const end = at + array_.text.size();
        while (true) {
            while (at != end && std::string_view(" \t\r\n").find(*at) != std::string_view::npos) ++at;
            if (at == end) break;
            double value = 0.0;
            const auto [next, error] = std::from_chars(at, end, value);
            if (error != std::errc()) fail("what stands between the numbers is none");
            if (values.size() == count) fail(fmt::format("there are more than the {} numbers of the image", count));
            values.push_back(value);
            at = next;
        }
        if (values.size() != count) too_few(count);
        return values;
    }

    [[noreturn]] void too_few(std::size_t count) const {
        fail(fmt::format("the data hold less than the {} numbers of the image", count));
    }

    std::string_view appended_part() const {
        const std::string* text = array_.attribute("offset");
        std::size_t offset = 0;
        const bool read =
            text != nullptr && std::from_chars(text->data(), text->data() + text->size(), offset).ec == std::errc();
        if (!read || offset > document_.appended.size()) fail("the offset does not lie within the appended data");
        return std::string_view(document_.appended).substr(offset);
    }

    std::string bytes_of(std::string_view part, bool base64, std::size_t most) const {
        if (!base64) return std::string(part.substr(0, most));
        auto bytes = from_base64(part, most);
        if (!bytes) fail("the data are no base64");
        return std::move(*bytes);
    }

    std::uint64_t word(const std::string& bytes, std::size_t index) const {
        if ((index + 1) * word_ > bytes.size()) fail("the data end within their header");
        std::array<char, 8> parts{};
        std::memcpy(parts.data(), bytes.data() + index * word_, word_);
        if (swapped_) std::reverse(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(word_));
        return load<std::uint64_t>(parts.data());
    }

    std::string decoded(std::string_view part, bool base64, std::size_t wanted) const {
        if (compressed_) return inflated(part, base64, wanted);
        const std::uint64_t length = word(bytes_of(part, base64, word_), 0);
        if (length != wanted)
            fail(fmt::format("the data hold {} bytes by their header; the image needs {}", length, wanted));
        if (part.size() < wanted) fail(fmt::format("the data end before their {} bytes", wanted));
        const std::string bytes = bytes_of(part, base64, word_ + wanted);
        if (bytes.size() != word_ + wanted) fail(fmt::format("the data end before their {} bytes", wanted));
        return bytes.substr(word_);
    }

    // Header: number of blocks, size of a block, size of the last one if it is smaller, compressed sizes.
    std::string inflated(std::string_view part, bool base64, std::size_t wanted) const {
        const std::string first = bytes_of(part, base64, 3 * word_);
        const std::uint64_t blocks = word(first, 0), block = word(first, 1), rest = word(first, 2);
        const bool whole_block = blocks > 1 || (blocks == 1 && rest == 0);
        if (blocks > part.size() / word_ || (whole_block && block > wanted))
            fail("the header of the compressed data does not fit them");
        const std::uint64_t total = blocks == 0 ? 0 : rest == 0 ? blocks * block : (blocks - 1) * block + rest;
        if (total != wanted)
            fail(fmt::format("the data hold {} bytes by their header; the image needs {}", total, wanted));
        const std::string header = bytes_of(part, base64, (3 + blocks) * word_);
        std::uint64_t packed = 0;
        for (std::size_t i = 0; i < blocks; ++i) {
            const std::uint64_t size = word(header, 3 + i);
            if (size > part.size()) fail("the header of the compressed data does not fit them");
            packed += size;
        }
        constexpr std::uint64_t best_ratio = 1100;  // zlib's: 1032
        if (packed > part.size() || total / best_ratio > packed)
            fail("the header of the compressed data does not fit them");
        const std::string all = bytes_of(part, base64, header.size() + packed);
        if (all.size() != header.size() + packed) fail("the compressed data end too early");
        return joined_blocks(all, header, block, rest);
    }

    std::string joined_blocks(const std::string& all, const std::string& header, std::uint64_t block,
                              std::uint64_t rest) const {
        const std::uint64_t blocks = word(header, 0);
        std::string result;
        std::size_t at = header.size();
        for (std::size_t i = 0; i < blocks; ++i) {
            const std::size_t packed = word(header, 3 + i);
            const std::size_t size = i + 1 == blocks && rest != 0 ? rest : block;
            std::string part(size, '\0');
            uLongf length = size;
            const int code = uncompress(reinterpret_cast<Bytef*>(part.data()), &length,
                                        reinterpret_cast<const Bytef*>(all.data() + at), packed);
            if (code != Z_OK || length != size) fail("the compressed data are damaged");
            result += part;
            at += packed;
        }
        return result;
    }

    std::vector<double> to_numbers(std::string& bytes, const VtkType& type, std::size_t count) const {
        std::vector<double> values(count);
        for (std::size_t i = 0; i < count; ++i) {
            char* const from = bytes.data() + i * type.size;
            if (swapped_) std::reverse(from, from + type.size);
            values[i] = type.read(from);
        }
        return values;
    }

    const XmlDocument& document_;
    const XmlElement& array_;
    std::size_t word_ = 4;
    bool swapped_ = false;
    bool compressed_ = false;
};

}  // namespace

std::vector<double> vtk_numbers(const XmlDocument& document, const XmlElement& array, std::size_t count) {
    return VtkReader(document, array).read(count);
}

}  // namespace pelage::imports
