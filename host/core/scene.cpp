// See scene.hpp.
#include "core/scene.hpp"

#include "core/adjacency.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/fields.hpp"
#include "core/philox.hpp"

#include <optional>
#include <utility>

namespace pelage {

namespace {

// Differences between cells of a lattice and their neighbours.
class Around {
public:
    Around(const Lattice& lattice, const Scene& scene, const std::vector<double>& values)
        : lattice_(lattice), columns_(scene.columns), rows_(scene.rows), values_(values) {}

    double laplacian(std::size_t cell) const {
        double sum = 0.0;
        const int reach = lattice_.reach();
        for (int up = -reach; up <= reach; ++up) {
            for (int right = -reach; right <= reach; ++right) {
                if (up != 0 && right != 0 && lattice_.stencil == Stencil::five_point) continue;
                sum += neighbour_share(lattice_, direction(right, up)) * difference(cell, right, up);
            }
        }
        return sum;
    }
    double gradient_x(std::size_t cell) const { return 0.5 * (difference(cell, 1, 0) - difference(cell, -1, 0)); }
    double gradient_y(std::size_t cell) const { return 0.5 * (difference(cell, 0, 1) - difference(cell, 0, -1)); }
    double stencil(const NamedStencil& stencil, std::size_t cell) const {
        double sum = 0.0;
        const int reach = stencil.reach();
        for (int up = -reach; up <= reach; ++up) {
            for (int right = -reach; right <= reach; ++right) {
                const auto column = place_repeated(cell % columns_, right, columns_, lattice_.boundary);
                const auto row = place_repeated(cell / columns_, up, rows_, lattice_.boundary);
                if (column && row) sum += stencil.weight(right, up) * values_[*row * columns_ + *column];
            }
        }
        return sum;
    }

private:
    // Theirs less the cell's own.
    double difference(std::size_t cell, int right, int up) const {
        const auto column = place_along(cell % columns_, right, columns_, lattice_.boundary);
        const auto row = place_along(cell / columns_, up, rows_, lattice_.boundary);
        if (column && row) return values_[*row * columns_ + *column] - values_[cell];
        return lattice_.boundary == Boundary::absorbing ? -values_[cell] : 0.0;
    }

    const Lattice& lattice_;
    std::size_t columns_, rows_;
    const std::vector<double>& values_;
};

// The same in a volume.
class AroundInVolume {
public:
    AroundInVolume(const Volume& volume, const std::vector<double>& values) : volume_(volume), values_(values) {}

    double laplacian(std::size_t cell) const {
        double sum = 0.0;
        for (int deep = -1; deep <= 1; ++deep) {
            for (int up = -1; up <= 1; ++up) {
                for (int right = -1; right <= 1; ++right) {
                    const Direction to = direction(right, up, deep);
                    sum += neighbour_share(volume_, to) * difference(cell, to);
                }
            }
        }
        return sum;
    }
    double gradient(std::size_t cell, Direction ahead, Direction back) const {
        return 0.5 * (difference(cell, ahead) - difference(cell, back));
    }

private:
    double difference(std::size_t cell, Direction to) const {
        const std::size_t line = cell / volume_.columns;
        const auto column = place_along(cell % volume_.columns, to.right, volume_.columns, volume_.boundary);
        const auto row = place_along(line % volume_.rows, to.up, volume_.rows, volume_.boundary);
        const auto layer = place_along(line / volume_.rows, to.deep, volume_.layers, volume_.boundary);
        if (column && row && layer)
            return values_[(*layer * volume_.rows + *row) * volume_.columns + *column] - values_[cell];
        return volume_.boundary == Boundary::absorbing ? -values_[cell] : 0.0;
    }

    const Volume& volume_;
    const std::vector<double>& values_;
};

class Columns {
public:
    explicit Columns(const Scene& scene) : scene_(scene) {}

    std::vector<double> of(const Operand& operand) {
        const std::size_t columns = scene_.columns == 0 ? 1 : scene_.columns;
        switch (operand.quantity) {
            case Quantity::x:
                return scene_.x;
            case Quantity::y:
                return scene_.y;
            case Quantity::z: {
                if (!scene_.z.empty()) return scene_.z;
                const std::vector<double> z = centres(0.0, scene_.layers);
                return each([&](std::size_t cell) { return z.empty() ? 0.0 : z[layer(cell)]; });
            }
            case Quantity::layer:
                return each([&](std::size_t cell) { return static_cast<double>(layer(cell)); });
            case Quantity::layers:
                return each([&](std::size_t) { return static_cast<double>(scene_.layers); });
            case Quantity::row:
                return each([&](std::size_t cell) {
                    return static_cast<double>(scene_.layers == 0 ? cell / columns : cell / columns % scene_.rows);
                });
            case Quantity::column:
                return each([&](std::size_t cell) { return static_cast<double>(cell % columns); });
            case Quantity::rows:
                return each([&](std::size_t) { return static_cast<double>(scene_.rows); });
            case Quantity::columns:
                return each([&](std::size_t) { return static_cast<double>(scene_.columns); });
            case Quantity::random:
                return draws(randoms_++);
            case Quantity::field:
                if (scene_.fields != nullptr && operand.index < scene_.fields->size())
                    return (*scene_.fields)[operand.index];
                break;
            case Quantity::concentration:
                if (scene_.conc != nullptr) return part(scene_.conc->at(operand.index));
                break;
            case Quantity::rate:
                if (scene_.diff != nullptr) return part(scene_.diff->at(operand.index));
                break;
            default:
                if (scene_.state != nullptr) return of_state(operand);
                break;
        }
        throw Error("an expression reads what there is in rules alone");
    }

private:
    std::size_t layer(std::size_t cell) const { return scene_.layers == 0 ? 0 : cell / (scene_.columns * scene_.rows); }

    std::vector<double> part(const std::vector<double>& of_all) const {
        const auto first = of_all.begin() + static_cast<std::ptrdiff_t>(scene_.first);
        return {first, first + static_cast<std::ptrdiff_t>(scene_.cells())};
    }

    std::vector<double> of_state(const Operand& operand) const {
        const Snapshot& state = *scene_.state;
        switch (operand.quantity) {
            case Quantity::neighbours:
                return {state.neighbours.begin(), state.neighbours.end()};
            case Quantity::birth:
                return {state.birth.begin(), state.birth.end()};
            case Quantity::age:
                return each([&](std::size_t cell) { return static_cast<double>(state.iteration - state.birth[cell]); });
            case Quantity::mapping:
                return state.mappings.at(operand.index);
            case Quantity::iteration:
                return each([&](std::size_t) { return static_cast<double>(state.iteration); });
            case Quantity::time:
                return each([&](std::size_t) { return scene_.time; });
            default:
                return of_neighbours(operand);
        }
    }
    std::vector<double> of_neighbours(const Operand& operand) const {
        if (scene_.volume != nullptr) return in_volume(operand);
        if (scene_.adjacency != nullptr && operand.quantity == Quantity::laplacian)
            return on_mesh(*scene_.adjacency, scene_.conc->at(operand.index));
        if (scene_.lattice == nullptr) throw Error("an expression reads what lattices alone have");
        const Around around(*scene_.lattice, scene_, scene_.conc->at(operand.index));
        if (operand.quantity == Quantity::laplacian)
            return each([&](std::size_t cell) { return around.laplacian(cell); });
        if (operand.quantity == Quantity::stencil) {
            if (scene_.stencils == nullptr) throw Error("an expression names a stencil that is not defined");
            const NamedStencil& stencil = scene_.stencils->at(operand.stencil);
            return each([&](std::size_t cell) { return around.stencil(stencil, cell); });
        }
        if (operand.quantity == Quantity::gradient_x)
            return each([&](std::size_t cell) { return around.gradient_x(cell); });
        return each([&](std::size_t cell) { return around.gradient_y(cell); });
    }

    std::vector<double> on_mesh(const Adjacency& adjacency, const std::vector<double>& values) const {
        return each([&](std::size_t cell) {
            double sum = 0.0;
            for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry)
                sum += adjacency.weights[entry] * (values[adjacency.indices[entry]] - values[cell]);
            return sum;
        });
    }

    std::vector<double> in_volume(const Operand& operand) const {
        const AroundInVolume around(*scene_.volume, scene_.conc->at(operand.index));
        const auto along = [&](Direction ahead, Direction back) {
            return each([&](std::size_t cell) { return around.gradient(cell, ahead, back); });
        };
        switch (operand.quantity) {
            case Quantity::laplacian:
                return each([&](std::size_t cell) { return around.laplacian(cell); });
            case Quantity::gradient_x:
                return along(direction(1, 0), direction(-1, 0));
            case Quantity::gradient_y:
                return along(direction(0, 1), direction(0, -1));
            case Quantity::gradient_z:
                return along(direction(0, 0, 1), direction(0, 0, -1));
            default:
                throw Error("an expression reads what lattices alone have");
        }
    }

    template <class F>
    std::vector<double> each(F&& value) const {
        std::vector<double> values(scene_.cells());
        for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell] = value(cell);
        return values;
    }

    std::vector<double> draws(std::uint32_t nth) const {
        return each([&](std::size_t cell) {
            const auto words =
                counted_words(scene_.first + cell, 0, scene_.place, scene_.purpose + 16 * (nth / 4), scene_.seed);
            return unit_uniform<double>(words[nth % 4]);
        });
    }

    const Scene& scene_;
    std::uint32_t randoms_ = 0;
};

}  // namespace

bool seen_by_field(Quantity quantity) {
    switch (quantity) {
        case Quantity::number:
        case Quantity::x:
        case Quantity::y:
        case Quantity::z:
        case Quantity::row:
        case Quantity::column:
        case Quantity::layer:
        case Quantity::rows:
        case Quantity::columns:
        case Quantity::layers:
        case Quantity::random:
        case Quantity::field:
            return true;
        default:
            return false;
    }
}

bool seen_at_start(Quantity quantity) {
    return seen_by_field(quantity) || quantity == Quantity::concentration || quantity == Quantity::rate;
}

std::vector<double> evaluate(const Expression& expression, const Scene& scene) {
    const std::vector<ExpressionNode>& nodes = expression.nodes;
    Columns columns(scene);
    std::vector<std::vector<double>> held(nodes.size());
    Leaves<double> leaves{std::vector<Leaf<double>>(nodes.size()), {}};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const Operand& operand = nodes[n].operand;
        if (nodes[n].operation != Operation::operand) continue;
        if (operand.quantity == Quantity::number) {
            leaves.values[n] = {nullptr, operand.value};
        } else {
            held[n] = columns.of(operand);
            leaves.values[n] = {held[n].data(), 0.0};
        }
    }
    leaves.exact = leaves.values;
    std::vector<double> values(scene.cells());
    evaluate(expression, leaves, values.size(), values.data());
    return values;
}

}  // namespace pelage
