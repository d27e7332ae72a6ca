// What Ready's chemicals begin with: the image of the file, and the overlays of its initial pattern generator.
#include "import/ready.hpp"
#include "import/vtk_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::imports {

namespace {

struct Point {
    double x, y, z;
};

bool is_true(const XmlElement& element, std::string_view attribute) {
    const std::string* text = element.attribute(attribute);
    return text == nullptr || *text == "true" || *text == "1";
}

// ---- the image

void put_image(ReadyPattern& pattern, std::size_t chemical, std::vector<double> values) {
    const auto [low, high] = std::ranges::minmax(values);
    for (double& value : values) {
        if (std::isfinite(value)) continue;
        pattern.problems.note(
            fmt::format("{}: numbers of the image that are not finite begin as 0", pattern.document.name));
        value = 0.0;
    }
    if (low == high) {
        pattern.draft.chemicals[chemical].start = number_term(low);
    } else {
        pattern.draft.chemicals[chemical].picture = std::move(values);
    }
}

void read_components(ReadyPattern& pattern, const XmlElement& array, std::size_t cells) {
    const std::size_t chemicals = pattern.chemicals.size();
    const std::vector<double> all = vtk_numbers(pattern.document, array, cells * chemicals);
    for (std::size_t i = 0; i < chemicals; ++i) {
        std::vector<double> values(cells);
        for (std::size_t cell = 0; cell < cells; ++cell) values[cell] = all[cell * chemicals + i];
        put_image(pattern, i, std::move(values));
    }
}

// Either an array for each chemical, by its name, or one whose components are the chemicals.
void read_image(ReadyPattern& pattern) {
    const XmlElement& piece = *pattern.document.root.child("ImageData")->child("Piece");
    const XmlElement* data = piece.child("PointData");
    if (data == nullptr || data->children.empty()) data = piece.child("CellData");
    if (data == nullptr) pattern.fail(piece, "the image holds no PointData");
    const std::size_t cells = pattern.draft.columns * pattern.draft.rows;
    const std::string components = std::to_string(pattern.chemicals.size());
    if (data->children.size() == 1 && pattern.chemicals.size() > 1) {
        const std::string* count = data->children[0].attribute("NumberOfComponents");
        if (count != nullptr && *count == components) return read_components(pattern, data->children[0], cells);
    }
    for (std::size_t i = 0; i < pattern.chemicals.size(); ++i) {
        const auto array = std::ranges::find_if(data->children, [&](const XmlElement& one) {
            const std::string* name = one.attribute("Name");
            return (name != nullptr && *name == pattern.chemicals[i]) ||
                   (pattern.chemicals.size() == 1 && data->children.size() == 1);
        });
        if (array == data->children.end())
            pattern.problems.note(fmt::format("{}: the image has no array '{}', which begins as 0",
                                              pattern.document.at(*data), pattern.chemicals[i]));
        else
            put_image(pattern, i, vtk_numbers(pattern.document, *array, cells));
    }
}

// ---- overlays

class Overlay {
public:
    Overlay(ReadyPattern& pattern, const XmlElement& element) : pattern_(pattern), element_(element) {}

    void read() {
        const std::string original = pattern_.required(element_, "chemical");
        const auto found = std::ranges::find(pattern_.chemicals, original);
        if (found == pattern_.chemicals.end()) {
            pattern_.problems.note(fmt::format("{}: the overlay of '{}', which is no chemical of the rule, is left out",
                                               pattern_.document.at(element_), original));
            return;
        }
        chemical_ = pattern_.names.of(original);
        for (const XmlElement& child : element_.children) {
            if (is_operation(child.name))
                operation_ = &child;
            else if (const auto value = fill(child))
                fill_ = value;
            else
                shapes_.push_back(shape(child));
        }
        pattern_.problems.check();
        if (operation_ == nullptr || !fill_ || shapes_.empty())
            pattern_.fail(element_, "an overlay needs an operation, a fill and a shape");
        write(static_cast<std::size_t>(found - pattern_.chemicals.begin()));
    }

private:
    static bool is_operation(std::string_view name) {
        return name == "overwrite" || name == "add" || name == "subtract" || name == "multiply" || name == "divide";
    }

    Point point(const XmlElement& of, std::size_t index) const {
        std::vector<const XmlElement*> points;
        for (const XmlElement& child : of.children) {
            if (child.name == "point3D" || child.name == "point3d") points.push_back(&child);
        }
        if (points.size() <= index) pattern_.fail(of, fmt::format("'{}' needs a point more", of.name));
        const auto part = [&](const char* name) { return pattern_.required_number(*points[index], name); };
        return {part("x"), part("y"), pattern_.one_dimensional ? 0.0 : part("z")};
    }

    double columns() const { return static_cast<double>(pattern_.draft.columns); }
    double rows() const { return static_cast<double>(pattern_.draft.rows); }
    static TermRef column() { return name_term("COLUMN"); }
    static TermRef row() { return name_term("ROW"); }

    // The distance, in cells, from a point whose parts are fractions of the image; the image lies at z = 0.
    TermRef distance(const Point& p, bool flat) const {
        const TermRef x = minus(column(), times(number_term(p.x), name_term("COLUMNS")));
        const TermRef y = minus(row(), times(number_term(p.y), name_term("ROWS")));
        if (flat && pattern_.one_dimensional) return call_term("abs", {x});
        TermRef far = call_term("hypot", {x, y});
        return flat || p.z == 0.0 ? far : call_term("hypot", {far, number_term(p.z)});
    }

    // How far along the way from one point to another a place is, both as fractions of the image: 0 to 1.
    TermRef way_along(const Point& a, const Point& b, const XmlElement& of) const {
        const double bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z;
        const double square = bx * bx + by * by + bz * bz;
        if (!(square > 0.0)) pattern_.fail(of, fmt::format("the two points of '{}' are one", of.name));
        const TermRef x =
            times(minus(over(column(), name_term("COLUMNS")), number_term(a.x)), number_term(bx / square));
        const TermRef y = times(minus(over(row(), name_term("ROWS")), number_term(a.y)), number_term(by / square));
        return plus(plus(x, y), number_term(-a.z * bz / square + 0.0));
    }

    TermRef between(const XmlElement& of, const TermRef& way) const {
        const double first = pattern_.required_number(of, "val1"), second = pattern_.required_number(of, "val2");
        return plus(number_term(first), times(number_term(second - first), way));
    }

    std::optional<TermRef> fill(const XmlElement& of) const {
        if (of.name == "constant") return number_term(pattern_.required_number(of, "value"));
        if (of.name == "white_noise") {
            const double low = pattern_.required_number(of, "low"), high = pattern_.required_number(of, "high");
            return plus(number_term(low), times(minus(number_term(high), number_term(low)), name_term("RANDOM")));
        }
        if (of.name == "other_chemical") return name_of_other(of);
        if (of.name == "parameter") return parameter(of);
        if (of.name == "linear_gradient") return between(of, way_along(point(of, 0), point(of, 1), of));
        if (of.name == "radial_gradient") return radial(of);
        if (of.name == "gaussian") return gaussian(of);
        if (of.name == "sine") {
            const TermRef turn =
                times(times(number_term(2.0), name_term("PI")), way_along(point(of, 0), point(of, 1), of));
            return times(number_term(pattern_.required_number(of, "amplitude")),
                         call_term("sin", {minus(turn, number_term(pattern_.required_number(of, "phase")))}));
        }
        return std::nullopt;
    }

    TermRef name_of_other(const XmlElement& of) const {
        const std::string other = pattern_.required(of, "chemical");
        if (std::ranges::find(pattern_.chemicals, other) == pattern_.chemicals.end())
            pattern_.fail(of, fmt::format("'{}' is no chemical of the rule", other));
        return name_term(pattern_.names.of(other));
    }

    TermRef parameter(const XmlElement& of) const {
        const std::string name = pattern_.required(of, "name");
        if (!pattern_.parameters.contains(name))
            pattern_.fail(of, fmt::format("'{}' is no parameter of the rule", name));
        return name_term(pattern_.names.of(name));
    }

    TermRef radial(const XmlElement& of) const {
        const Point a = point(of, 0), b = point(of, 1);
        const double full = std::hypot((b.x - a.x) * columns(), (b.y - a.y) * rows(), b.z - a.z);
        if (!(full > 0.0)) pattern_.fail(of, "the two points of 'radial_gradient' are one");
        return between(of, over(distance(a, false), number_term(full)));
    }

    TermRef gaussian(const XmlElement& of) const {
        const double sigma = pattern_.required_number(of, "sigma") * std::max(columns(), rows());
        if (!(sigma > 0.0)) pattern_.fail(of, "the sigma of 'gaussian' must be above 0");
        const TermRef square = call_term("^", {distance(point(of, 0), false), number_term(2.0)});
        return times(number_term(pattern_.required_number(of, "height")),
                     call_term("exp", {negated(over(square, number_term(2.0 * sigma * sigma)))}));
    }

    TermRef shape(const XmlElement& of) const {
        if (of.name == "everywhere") return number_term(1.0);
        if (of.name == "rectangle") return rectangle(point(of, 0), point(of, 1));
        if (of.name == "circle") {
            const double radius = pattern_.required_number(of, "radius") * std::max(columns(), rows());
            return call_term("<", {distance(point(of, 0), true), number_term(radius)});
        }
        if (of.name == "pixel") {
            const auto is = [&](const TermRef& place, const char* part) {
                return call_term("==", {place, number_term(pattern_.required_number(of, part))});
            };
            return pattern_.one_dimensional ? is(column(), "x") : call_term("and", {is(column(), "x"), is(row(), "y")});
        }
        pattern_.problems.refuse(
            fmt::format("{}: '{}' in an overlay is not carried over", pattern_.document.at(of), of.name));
        return number_term(1.0);
    }

    TermRef rectangle(const Point& a, const Point& b) const {
        const auto within = [](const TermRef& at, double low, double high) {
            return call_term("and",
                             {call_term(">=", {at, number_term(low)}), call_term("<=", {at, number_term(high)})});
        };
        const TermRef x = within(over(column(), name_term("COLUMNS")), a.x, b.x);
        return pattern_.one_dimensional ? x : call_term("and", {x, within(over(row(), name_term("ROWS")), a.y, b.y)});
    }

    TermRef result() const {
        const TermRef old = name_term(chemical_);
        if (operation_->name == "add") return plus(old, *fill_);
        if (operation_->name == "subtract") return minus(old, *fill_);
        if (operation_->name == "multiply") return times(old, *fill_);
        if (operation_->name == "divide") return over(old, *fill_);
        return *fill_;
    }

    // An overlay goes into the chemical's `use` where it covers everything, needs nothing of what was, and nothing has
    // needed or changed the chemical.
    void write(std::size_t index) {
        const TermRef value = result();
        DraftChemical& chemical = pattern_.draft.chemicals[index];
        const auto of_place = [&](const std::string& name) {
            return !pattern_.names.known(name) || pattern_.is_parameter(name);
        };
        const bool plain = operation_->name == "overwrite" && shapes_.size() == 1 && is_number(shapes_[0], 1.0) &&
                           of_names_only(value, of_place);
        const auto named = [&](const std::string& line) { return has_word(line, chemical.name); };
        if (plain && std::ranges::none_of(pattern_.draft.starts, named)) {
            chemical.start = value;
            chemical.picture.clear();
            return;
        }
        for (const TermRef& where : shapes_)
            pattern_.draft.starts.push_back(fmt::format("set cells where ({}) chemical {} conc ({})", text_of(where),
                                                        chemical.name, text_of(value)));
    }

    ReadyPattern& pattern_;
    const XmlElement& element_;
    std::string chemical_;
    const XmlElement* operation_ = nullptr;
    std::optional<TermRef> fill_;
    std::vector<TermRef> shapes_;
};

}  // namespace

void read_ready_start(ReadyPattern& pattern) {
    const XmlElement* generator = pattern.rd.child("initial_pattern_generator");
    const bool generated = generator != nullptr && is_true(*generator, "apply_when_loading");
    if (!generated || !is_true(*generator, "zero_first")) read_image(pattern);
    if (!generated) return;
    for (const XmlElement& element : generator->children) {
        if (element.name == "overlay") Overlay(pattern, element).read();
    }
}

}  // namespace pelage::imports
