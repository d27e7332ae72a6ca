// See scene.hpp.
#include "core/scene.hpp"

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/philox.hpp"

#include <utility>

namespace pelage {

namespace {

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
            case Quantity::row:
                return each([&](std::size_t cell) { return static_cast<double>(cell / columns); });
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
                if (scene_.conc != nullptr) return scene_.conc->at(operand.index);
                break;
            case Quantity::rate:
                if (scene_.diff != nullptr) return scene_.diff->at(operand.index);
                break;
            default:
                break;
        }
        throw Error("an expression reads what there is in rules alone");
    }

private:
    template <class F>
    std::vector<double> each(F&& value) const {
        std::vector<double> values(scene_.cells());
        for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell] = value(cell);
        return values;
    }

    std::vector<double> draws(std::uint32_t nth) const {
        return each([&](std::size_t cell) {
            const auto words = counted_words(cell, 0, scene_.place, scene_.purpose + 16 * (nth / 4), scene_.seed);
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
        case Quantity::row:
        case Quantity::column:
        case Quantity::rows:
        case Quantity::columns:
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
