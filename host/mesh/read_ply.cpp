// See read_ply.hpp.
#include "mesh/read_ply.hpp"

#include "core/error.hpp"
#include "core/experiment.hpp"
#include "mesh/numbers.hpp"
#include "mesh/ply_header.hpp"
#include "mesh/polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace pelage {

namespace {

// The numbers behind the head, one after the other.
class PlyNumbers {
public:
    PlyNumbers(std::string_view bytes, const PlyHeader& header, const std::string& name)
        : bytes_(bytes), rest_(bytes.substr(header.bytes)), form_(header.form), name_(name), line_(header.lines + 1) {}

    [[noreturn]] void fail(const std::string& what) const {
        if (form_ == PlyForm::ascii) throw Error(fmt::format("{}:{}: {}", name_, line_, what));
        throw Error(fmt::format("{}: byte {}: {}", name_, bytes_.size() - rest_.size(), what));
    }

    double next(PlyType type) { return form_ == PlyForm::ascii ? next_word_of(type) : next_bytes_of(type); }

    std::size_t bytes_left() const { return rest_.size(); }

    void check_end() {
        if (form_ == PlyForm::ascii) skip_blanks();
        if (!rest_.empty()) fail(fmt::format("{} bytes more than the elements that are announced take", rest_.size()));
    }

private:
    void skip_blanks() {
        while (!rest_.empty() && (rest_[0] == ' ' || (rest_[0] >= '\t' && rest_[0] <= '\r'))) {
            if (rest_[0] == '\n') ++line_;
            rest_.remove_prefix(1);
        }
    }

    double next_word_of(PlyType type) {
        skip_blanks();
        if (rest_.empty()) fail("the file ends before the elements that are announced");
        const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\n\v\f\r"));
        const std::optional<double> value = to_double(word);
        if (!value) fail(fmt::format("{}; allowed here is a number", shown(word)));
        if (is_whole(type) && *value != std::floor(*value))
            fail(fmt::format("{}; allowed here is a whole number", shown(word)));
        rest_.remove_prefix(word.size());
        return *value;
    }

    double next_bytes_of(PlyType type) {
        const std::size_t size = ply_size(type);
        if (rest_.size() < size) fail("the file ends before the elements that are announced");
        std::array<char, 8> bytes{};
        std::copy_n(rest_.begin(), size, bytes.begin());
        if (form_ == PlyForm::big_endian)
            std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        rest_.remove_prefix(size);
        return number(bytes.data(), type);
    }

    template <class T>
    static double as(const char* from) {
        static_assert(std::endian::native == std::endian::little);
        T value;
        std::memcpy(&value, from, sizeof value);
        return static_cast<double>(value);
    }

    static double number(const char* from, PlyType type) {
        switch (type) {
            case PlyType::int8:
                return as<std::int8_t>(from);
            case PlyType::uint8:
                return as<std::uint8_t>(from);
            case PlyType::int16:
                return as<std::int16_t>(from);
            case PlyType::uint16:
                return as<std::uint16_t>(from);
            case PlyType::int32:
                return as<std::int32_t>(from);
            case PlyType::uint32:
                return as<std::uint32_t>(from);
            case PlyType::float32:
                return as<float>(from);
            case PlyType::float64:
                break;
        }
        return as<double>(from);
    }

    std::string_view bytes_, rest_;
    PlyForm form_;
    const std::string& name_;
    std::size_t line_;
};

class PlyReader {
public:
    PlyReader(std::string_view bytes, const std::string& name)
        : header_(parse_ply_header(bytes, name)), name_(name), numbers_(bytes, header_, name) {}

    Mesh read() {
        check_header();
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                read_vertices(element);
            } else if (element.name == "face") {
                read_faces(element);
            } else {
                for (std::uint64_t i = 0; i < element.count; ++i) read_record(element, none, nullptr);
            }
        }
        numbers_.check_end();
        return std::move(mesh_);
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    [[noreturn]] void refuse(const std::string& what) const { throw Error(name_ + ": " + what); }

    const PlyElement& element(std::string_view wanted) const {
        const auto found = std::ranges::find(header_.elements, wanted, &PlyElement::name);
        if (found == header_.elements.end() || found->count == 0)
            refuse(fmt::format("no element '{}' in the file", wanted));
        return *found;
    }

    void check_header() {
        const PlyElement& vertex = element("vertex");
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::optional<std::size_t> at = vertex.property(std::string_view("xyz").substr(axis, 1));
            if (!at || vertex.properties[*at].count)
                refuse(fmt::format("the element 'vertex' has no number '{}'", "xyz"[axis]));
            coordinates_[axis] = *at;
        }
        if (vertex.count > largest_cell_count)
            refuse(fmt::format("{} vertices; at most {} are allowed", vertex.count, largest_cell_count));
        const PlyElement& face = element("face");
        std::optional<std::size_t> at = face.property("vertex_indices");
        if (!at) at = face.property("vertex_index");
        if (!at || !face.properties[*at].count || !is_whole(face.properties[*at].type))
            refuse("the element 'face' has no list 'vertex_indices' (or 'vertex_index') of whole numbers");
        corners_at_ = *at;
    }

    // One of an element. `values`, where not null, takes its numbers, of a list its length; of the list at place `list`
    // the entries go to list_.
    void read_record(const PlyElement& element, std::size_t list, std::vector<double>* values) {
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            const double first = numbers_.next(property.count.value_or(property.type));
            if (values != nullptr) values->push_back(first);
            if (property.count) read_list(property, first, i == list);
        }
    }

    void read_list(const PlyProperty& property, double length, bool keep) {
        if (length < 0 || length > static_cast<double>(numbers_.bytes_left()))
            numbers_.fail(fmt::format("a list of {} entries, with {} bytes left", length, numbers_.bytes_left()));
        if (keep && length > static_cast<double>(largest_polygon))
            numbers_.fail(fmt::format("a face of {} corners; at most {} are allowed", length, largest_polygon));
        if (keep) list_.clear();
        for (double i = 0; i < length; ++i) {
            const double entry = numbers_.next(property.type);
            if (keep) list_.push_back(entry);
        }
    }

    void read_vertices(const PlyElement& element) {
        mesh_.vertices.reserve(element.count);
        std::vector<double> values;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            values.clear();
            read_record(element, none, &values);
            Point place{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                place[axis] = values[coordinates_[axis]];
                const std::string fault = coordinate_fault(place[axis]);
                if (!fault.empty()) numbers_.fail(fault);
            }
            mesh_.vertices.push_back(place);
        }
    }

    void read_faces(const PlyElement& element) {
        const auto count = static_cast<double>(this->element("vertex").count);
        std::vector<std::uint32_t> corners;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            read_record(element, corners_at_, nullptr);
            corners.clear();
            for (const double corner : list_) {
                if (!(corner >= 0 && corner < count))
                    numbers_.fail(fmt::format("a face names vertex {}; there are {}, counted from 0", corner, count));
                corners.push_back(static_cast<std::uint32_t>(corner));
            }
            const std::string fault = add_polygon(mesh_, corners);
            if (!fault.empty()) numbers_.fail(fault);
        }
    }

    PlyHeader header_;
    const std::string& name_;
    PlyNumbers numbers_;
    std::array<std::size_t, 3> coordinates_{};
    std::size_t corners_at_ = 0;
    std::vector<double> list_;
    Mesh mesh_;
};

}  // namespace

Mesh parse_ply(std::string_view bytes, const std::string& name) { return PlyReader(bytes, name).read(); }

}  // namespace pelage
