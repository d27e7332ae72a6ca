// See read_obj.hpp.
#include "mesh/read_obj.hpp"

#include "core/error.hpp"
#include "core/experiment.hpp"
#include "mesh/numbers.hpp"
#include "mesh/polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace pelage {

namespace {

// Statements without an effect on places and faces.
constexpr std::array<std::string_view, 13> passed_over{"vt", "vn", "vp",     "g",      "o",   "s",     "p",
                                                       "l",  "mg", "usemtl", "mtllib", "lod", "usemap"};

class ObjReader {
public:
    explicit ObjReader(const std::string& name) : name_(name) {}

    Mesh read(std::string_view bytes) {
        while (!bytes.empty()) {
            ++line_;
            read_line(cut_line(bytes));
        }
        if (mesh_.vertices.empty()) throw Error(name_ + ": no vertex ('v X Y Z') in the file");
        if (mesh_.triangles.empty()) throw Error(name_ + ": no face ('f V1 V2 V3 ...') in the file");
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}:{}: {}", name_, line_, what)); }

    void read_line(std::string_view line) {
        line = line.substr(0, line.find('#'));
        const std::string_view word = next_word(line);
        if (word.empty()) return;
        if (word == "v") return read_vertex(line);
        if (word == "f") return read_face(line);
        if (std::ranges::find(passed_over, word) != passed_over.end()) return;
        fail(fmt::format("{} begins a line; allowed are v, f, comments (#) and, passed over, {}", shown(word),
                         fmt::join(passed_over, ", ")));
    }

    void read_vertex(std::string_view line) {
        Point place{};
        std::size_t count = 0;
        for (std::string_view word = next_word(line); !word.empty(); word = next_word(line), ++count) {
            const std::optional<double> value = to_double(word);
            if (!value) fail(fmt::format("{} in a vertex; allowed are numbers", shown(word)));
            const std::string fault = coordinate_fault(*value);
            if (!fault.empty()) fail(fault);
            if (count < 3) place[count] = *value;
        }
        if (count < 3 || count == 5 || count > 7)
            fail(fmt::format("a vertex of {} numbers; allowed are 3 (x y z), 4 with a weight, 6 or 7 with a colour",
                             count));
        if (mesh_.vertices.size() == largest_cell_count) fail(fmt::format("more than {} vertices", largest_cell_count));
        mesh_.vertices.push_back(place);
    }

    void read_face(std::string_view line) {
        corners_.clear();
        for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
            if (corners_.size() > largest_polygon) break;
            corners_.push_back(corner(word));
        }
        const std::string fault = add_polygon(mesh_, corners_);
        if (!fault.empty()) fail(fault);
    }

    // V, V/T, V//N or V/T/N, counted from 1, or from the latest backwards from -1.
    std::uint32_t corner(std::string_view word) const {
        const auto wrong = [&] {
            fail(fmt::format("the corner {} of a face; allowed are V, V/T, V//N and V/T/N of whole numbers",
                             shown(word)));
        };
        const std::size_t end = std::min(word.find('/'), word.size());
        const std::optional<std::int64_t> place = to_integer(word.substr(0, end));
        if (!place) wrong();
        std::string_view rest = word.substr(end);
        for (int part = 0; !rest.empty(); ++part) {
            rest.remove_prefix(1);
            const std::string_view number = rest.substr(0, rest.find('/'));
            rest.remove_prefix(number.size());
            const bool left_out = part == 0 && number.empty() && !rest.empty();
            if (part > 1 || (!left_out && !to_integer(number))) wrong();
        }
        const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
        const std::int64_t index = *place < 0 ? count + *place : *place - 1;
        if (index < 0 || index >= count)
            fail(fmt::format("a face names vertex {}; {} vertices stand before it, counted from 1", *place, count));
        return static_cast<std::uint32_t>(index);
    }

    const std::string& name_;
    std::size_t line_ = 0;
    Mesh mesh_;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

Mesh parse_obj(std::string_view bytes, const std::string& name) { return ObjReader(name).read(bytes); }

}  // namespace pelage
