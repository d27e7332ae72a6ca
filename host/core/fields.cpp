// See fields.hpp.
#include "core/fields.hpp"

#include "core/blobs.hpp"
#include "core/error.hpp"
#include "core/philox.hpp"
#include "core/scene.hpp"
#include "core/space.hpp"
#include "core/stands.hpp"
#include "core/subnormal.hpp"
#include "core/visit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pelage {

namespace {

double pixel(const Field& picture, std::size_t column, std::size_t row) {
    return picture.values[row * picture.columns + column];
}

// Two neighbouring pixels and how far the place lies from the first towards the second.
struct Between {
    std::size_t first = 0, second = 0;
    double share = 0.0;
};

// Cell `i` of `count` over a picture of `pixels`: both cover the same stretch, and have their values at their centres.
Between between(std::size_t i, std::size_t count, std::size_t pixels) {
    const double at = (static_cast<double>(i) + 0.5) / static_cast<double>(count) * static_cast<double>(pixels) - 0.5;
    const double held = std::clamp(at, 0.0, static_cast<double>(pixels - 1));
    const auto first = static_cast<std::size_t>(held);
    return {first, std::min(first + 1, pixels - 1), held - static_cast<double>(first)};
}

double mixed(double a, double b, double share) { return share == 0.0 ? a : a + share * (b - a); }

double stretched(const Field& picture, const Extent& extent, std::size_t column, std::size_t row) {
    const Between x = between(column, extent.columns, picture.columns);
    const Between y = between(row, extent.rows, picture.rows);
    const auto along = [&](std::size_t at) {
        return mixed(pixel(picture, x.first, at), pixel(picture, x.second, at), x.share);
    };
    return mixed(along(y.first), along(y.second), y.share);
}

// The pixel over a cell when the middles of picture and lattice coincide; none beside the picture.
std::optional<std::size_t> centred(std::size_t i, std::size_t count, std::size_t pixels) {
    const auto at =
        static_cast<std::ptrdiff_t>(i) + (static_cast<std::ptrdiff_t>(pixels) - static_cast<std::ptrdiff_t>(count)) / 2;
    if (at < 0 || at >= static_cast<std::ptrdiff_t>(pixels)) return std::nullopt;
    return static_cast<std::size_t>(at);
}

double of_picture(const PictureField& field, const Extent& extent, std::size_t column, std::size_t row) {
    const Field& picture = *field.picture;
    if (field.fit == Fit::stretch) return stretched(picture, extent, column, row);
    if (field.fit == Fit::tile) return pixel(picture, column % picture.columns, row % picture.rows);
    const auto x = centred(column, extent.columns, picture.columns);
    const auto y = centred(row, extent.rows, picture.rows);
    return x && y ? pixel(picture, *x, *y) : field.beside;
}

std::vector<double> from_picture(const PictureField& field, const Extent& extent) {
    std::vector<double> values;
    values.reserve(extent.columns * extent.rows);
    for (std::size_t row = 0; row < extent.rows; ++row) {
        for (std::size_t column = 0; column < extent.columns; ++column)
            values.push_back(of_picture(field, extent, column, row));
    }
    return values;
}

Scene scene_of(const Experiment& experiment, const Extent& extent) {
    Scene scene;
    scene.columns = extent.columns;
    scene.rows = extent.rows;
    scene.layers = extent.layers;
    const std::vector<double> x = centres(extent.origin_x, extent.columns);
    const std::vector<double> rows = centres(extent.origin_y, extent.rows);
    for (std::size_t layer = 0; layer < std::max<std::size_t>(extent.layers, 1); ++layer) {
        for (const double y : rows) {
            scene.x.insert(scene.x.end(), x.begin(), x.end());
            scene.y.insert(scene.y.end(), x.size(), y);
        }
    }
    scene.seed = experiment.run_seed();
    scene.purpose = purpose::field;
    return scene;
}

std::vector<double> from_blobs(const BlobField& field, const Experiment& experiment, const Extent& extent,
                               std::size_t place) {
    const Space space = space_of(experiment);
    if (const auto* volume = std::get_if<Volume>(&space))
        return blob_values(field, *volume, experiment.run_seed(), place);
    Lattice lattice = std::get<Lattice>(space);
    lattice.columns = extent.columns;
    lattice.rows = extent.rows;
    return blob_values(field, lattice, experiment.run_seed(), place);
}

double in_run(double value, Precision precision) {
    return precision == Precision::double_ ? value : double{in_precision<float>(value)};
}

// Of its expression, or of its statement.
std::string place_of(const Experiment& experiment, const PlaceField& field) {
    const auto* computed = std::get_if<ComputedField>(&field.source);
    return where_stands(experiment, field.line, computed != nullptr ? computed->expression.text : "define");
}

// A part of an expression may be infinite or no number where the whole does not mind.
void check(const Experiment& experiment, const PlaceField& field, const Extent& extent,
           const std::vector<double>& values) {
    if (field.name.empty()) return;
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
        if (std::isfinite(values[cell])) continue;
        const std::size_t line = cell / extent.columns;
        const std::string layer = extent.layers == 0 ? "" : fmt::format(", layer {}", line / extent.rows);
        throw Error(fmt::format("{}: field '{}' is {} in column {}, row {}{}; it must be a number everywhere",
                                place_of(experiment, field), field.name,
                                std::isnan(values[cell]) ? "no number" : "infinite", cell % extent.columns,
                                line % extent.rows, layer));
    }
}

}  // namespace

Extent extent_of(const Snapshot& state) {
    return {state.columns, state.rows, state.origin_x, state.origin_y, state.layers};
}

std::vector<double> centres(double origin, std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double offset = (static_cast<double>(i) - static_cast<double>(count) / 2.0) * 2 + 1;
        values[i] = origin + offset;
    }
    return values;
}

std::vector<std::vector<double>> field_values(const Experiment& experiment, const Extent& extent, Precision precision) {
    if (experiment.fields.empty()) return {};
    Scene scene = scene_of(experiment, extent);
    std::vector<std::vector<double>> fields;
    scene.fields = &fields;
    for (std::size_t i = 0; i < experiment.fields.size(); ++i) {
        const PlaceField& field = experiment.fields[i];
        scene.place = static_cast<std::uint32_t>(i);
        std::vector<double> values =
            std::visit(Overloaded{[&](const ComputedField& one) { return evaluate(one.expression, scene); },
                                  [&](const PictureField& one) { return from_picture(one, extent); },
                                  [&](const BlobField& one) { return from_blobs(one, experiment, extent, i); }},
                       field.source);
        for (double& value : values) value = in_run(value, precision);
        check(experiment, field, extent, values);
        fields.push_back(std::move(values));
    }
    return fields;
}

std::vector<std::vector<double>> mesh_blobs(const Experiment& experiment, const MeshSurface& surface,
                                            Precision precision) {
    std::vector<std::vector<double>> fields(experiment.fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto* blobs = std::get_if<BlobField>(&experiment.fields[i].source);
        if (blobs == nullptr) continue;
        fields[i] = blob_values(*blobs, surface, experiment.run_seed(), i);
        for (double& value : fields[i]) value = in_run(value, precision);
    }
    return fields;
}

// ---- what is computed once

namespace {

// What is known of a node and all that it is made of.
struct Part {
    bool of_place = true;  // else it depends on what changes
    bool reads = false;    // the place, not numbers alone
    std::size_t cost = 0;  // operations; a function counts for several
};

bool fixed_in_place(Quantity quantity) { return seen_by_field(quantity) && quantity != Quantity::random; }

std::vector<Part> parts_of(const Expression& expression) {
    constexpr std::size_t of_function = 4;
    std::vector<Part> parts;
    for (const ExpressionNode& node : expression.nodes) {
        Part part;
        if (node.operation == Operation::operand) {
            const Quantity quantity = node.operand.quantity;
            part.of_place = fixed_in_place(quantity);
            part.reads = quantity != Quantity::number;
        } else {
            part.cost = node.operation == Operation::call ? of_function : 1;
        }
        for (const std::size_t argument : node.arguments) {
            part.of_place = part.of_place && parts[argument].of_place;
            part.reads = part.reads || parts[argument].reads;
            part.cost += parts[argument].cost;
        }
        parts.push_back(part);
    }
    return parts;
}

// The node and all that it is made of, as an expression of its own.
class Extract {
public:
    explicit Extract(const Expression& expression)
        : from_(expression), places_(expression.nodes.size(), expression.nodes.size()) {}

    Expression of(std::size_t node) {
        take(node);
        return {from_.text, std::move(nodes_), from_.line};
    }

private:
    // Arguments come before what they belong to, so no recursion is needed.
    void take(std::size_t last) {
        std::vector<bool> wanted(last + 1, false);
        wanted[last] = true;
        for (std::size_t n = last + 1; n-- > 0;) {
            if (!wanted[n]) continue;
            for (const std::size_t argument : from_.nodes[n].arguments) wanted[argument] = true;
        }
        for (std::size_t n = 0; n <= last; ++n) {
            if (!wanted[n]) continue;
            ExpressionNode node = from_.nodes[n];
            for (std::size_t& argument : node.arguments) argument = places_[argument];
            places_[n] = nodes_.size();
            nodes_.push_back(std::move(node));
        }
    }

    const Expression& from_;
    std::vector<std::size_t> places_;  // of the nodes taken
    std::vector<ExpressionNode> nodes_;
};

std::size_t nameless_field(Experiment& experiment, Expression expression) {
    for (std::size_t i = 0; i < experiment.fields.size(); ++i) {
        const auto* known = std::get_if<ComputedField>(&experiment.fields[i].source);
        if (known != nullptr && known->expression.nodes == expression.nodes) return i;
    }
    const std::size_t line = expression.line;
    experiment.fields.push_back({"", line, ComputedField{std::move(expression)}});
    return experiment.fields.size() - 1;
}

// Puts fields in the place of parts, and drops the nodes that nothing refers to any more.
void compute_once(Experiment& experiment, Expression& expression) {
    constexpr std::size_t worth_a_plane = 3;
    const std::vector<Part> parts = parts_of(expression);
    const std::size_t last = expression.nodes.size() - 1;
    std::vector<bool> wanted(expression.nodes.size(), false);
    wanted[last] = true;
    for (std::size_t n = last + 1; n-- > 0;) {
        if (!wanted[n]) continue;
        const Part& part = parts[n];
        if (part.of_place && part.reads && part.cost >= worth_a_plane &&
            experiment.fields.size() < largest_field_count) {
            const std::size_t field = nameless_field(experiment, Extract(expression).of(n));
            expression.nodes[n] = {Operation::operand, {Quantity::field, 0.0, field}, {}, 0, {}};
        }
        for (const std::size_t argument : expression.nodes[n].arguments) wanted[argument] = true;
    }
    expression = Extract(expression).of(last);
}

}  // namespace

void compute_places_once(Experiment& experiment) {
    if (!on_grid(space_of(experiment))) return;
    for (Expression& expression : experiment.expressions) compute_once(experiment, expression);
}

}  // namespace pelage
