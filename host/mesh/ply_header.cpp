// See ply_header.hpp.
#include "mesh/ply_header.hpp"

#include "core/error.hpp"
#include "mesh/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pelage {

namespace {

constexpr std::size_t most_parts = 100;  // elements, and properties of one
constexpr std::size_t longest_line = 4096;

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_words{{{"char", PlyType::int8},
                                                                           {"uchar", PlyType::uint8},
                                                                           {"short", PlyType::int16},
                                                                           {"ushort", PlyType::uint16},
                                                                           {"int", PlyType::int32},
                                                                           {"uint", PlyType::uint32},
                                                                           {"float", PlyType::float32},
                                                                           {"double", PlyType::float64},
                                                                           {"int8", PlyType::int8},
                                                                           {"uint8", PlyType::uint8},
                                                                           {"int16", PlyType::int16},
                                                                           {"uint16", PlyType::uint16},
                                                                           {"int32", PlyType::int32},
                                                                           {"uint32", PlyType::uint32},
                                                                           {"float32", PlyType::float32},
                                                                           {"float64", PlyType::float64}}};

class HeaderReader {
public:
    HeaderReader(std::string_view bytes, const std::string& name) : whole_(bytes), rest_(bytes), name_(name) {}

    PlyHeader read() {
        if (line() != "ply") fail("a PLY file begins with the line 'ply'");
        read_form(line());
        for (std::string_view text = line(); text != "end_header"; text = line()) read_line(text);
        header_.lines = line_;
        header_.bytes = whole_.size() - rest_.size();
        check_counts();
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}:{}: {}", name_, line_, what)); }

    // The next line; one that ends with \r alone is not cut there, for binary data may follow.
    std::string_view line() {
        ++line_;
        const std::size_t end = rest_.substr(0, longest_line).find('\n');
        if (end == std::string_view::npos)
            fail(fmt::format(
                "no end of this line within {} bytes; the head of a PLY file is lines of text that 'end_header' ends",
                std::min(rest_.size(), longest_line)));
        std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        const std::size_t last = text.find_last_not_of(" \t\r");
        return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
    }

    void read_form(std::string_view text) {
        if (text == "format ascii 1.0") {
            header_.form = PlyForm::ascii;
        } else if (text == "format binary_little_endian 1.0") {
            header_.form = PlyForm::little_endian;
        } else if (text == "format binary_big_endian 1.0") {
            header_.form = PlyForm::big_endian;
        } else {
            fail(
                fmt::format("{}; allowed are 'format ascii 1.0', 'format binary_little_endian 1.0' and 'format "
                            "binary_big_endian 1.0'",
                            shown(text)));
        }
    }

    void read_line(std::string_view text) {
        const std::string_view word = next_word(text);
        if (word == "comment" || word == "obj_info") return;
        if (word == "element") return read_element(text);
        if (word == "property") return read_property(text);
        fail(fmt::format("{} begins a line; allowed are comment, obj_info, element, property and end_header",
                         shown(word)));
    }

    void read_element(std::string_view text) {
        if (!header_.elements.empty()) check_properties();
        const std::string_view word = next_word(text);
        const std::string_view number = next_word(text);
        const std::optional<std::int64_t> count = to_integer(number);
        if (word.empty() || !count || *count < 0 || !next_word(text).empty())
            fail("an element is 'element NAME COUNT' with a whole number from 0 on");
        const auto same = [&](const PlyElement& one) { return one.name == word; };
        if (std::ranges::any_of(header_.elements, same)) fail(fmt::format("a second element {}", shown(word)));
        if (header_.elements.size() == most_parts) fail(fmt::format("more than {} elements", most_parts));
        header_.elements.push_back({std::string(word), static_cast<std::uint64_t>(*count), {}});
    }

    void read_property(std::string_view text) {
        if (header_.elements.empty()) fail("a property stands before the first element");
        PlyElement& element = header_.elements.back();
        PlyProperty property;
        std::string_view word = next_word(text);
        if (word == "list") {
            property.count = type_of(next_word(text));
            if (!is_whole(*property.count)) fail("the length of a list is of a type of whole numbers");
            word = next_word(text);
        }
        property.type = type_of(word);
        property.name = next_word(text);
        if (property.name.empty() || !next_word(text).empty())
            fail("a property is 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
        if (element.property(property.name)) fail(fmt::format("a second property {}", shown(property.name)));
        if (element.properties.size() == most_parts) fail(fmt::format("more than {} properties", most_parts));
        element.properties.push_back(std::move(property));
    }

    PlyType type_of(std::string_view word) const {
        const auto found = std::ranges::find(type_words, word, [](const auto& one) { return one.first; });
        if (found == type_words.end())
            fail(fmt::format(
                "the type {}; allowed are char, uchar, short, ushort, int, uint, float, double, int8, uint8, "
                "int16, uint16, int32, uint32, float32 and float64",
                shown(word)));
        return found->second;
    }

    void check_properties() const {
        const PlyElement& last = header_.elements.back();
        if (last.properties.empty()) fail(fmt::format("the element {} before has no property", shown(last.name)));
    }

    void check_counts() const {
        if (!header_.elements.empty()) check_properties();
        for (const PlyElement& one : header_.elements) {
            const std::uint64_t held = (rest_.size() + 1) / one.least_bytes(header_.form == PlyForm::ascii);
            if (one.count > held)
                fail(fmt::format("{} of element {} are announced, but {} bytes of data hold at most {}", one.count,
                                 shown(one.name), rest_.size(), held));
        }
    }

    std::string_view whole_, rest_;
    const std::string& name_;
    std::size_t line_ = 0;
    PlyHeader header_;
};

}  // namespace

std::size_t ply_size(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> PlyElement::property(std::string_view wanted) const {
    const auto found = std::ranges::find(properties, wanted, &PlyProperty::name);
    if (found == properties.end()) return {};
    return static_cast<std::size_t>(found - properties.begin());
}

std::size_t PlyElement::least_bytes(bool ascii) const {
    std::size_t bytes = 0;
    for (const PlyProperty& one : properties) bytes += ascii ? 2 : ply_size(one.count.value_or(one.type));
    return bytes;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) { return HeaderReader(bytes, name).read(); }

}  // namespace pelage
