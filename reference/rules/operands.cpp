// Evaluates operands for all cells at once.
#include "reference/rules/operands.hpp"

#include "core/fields.hpp"
#include "core/philox.hpp"
#include "core/subnormal.hpp"

#include <array>
#include <utility>

namespace pelage::reference {

namespace {

template <class T, class F>
Column<T> of_each(std::size_t cells, F&& value_of) {
    std::vector<T> values(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) values[cell] = static_cast<T>(value_of(cell));
    return Column<T>(std::move(values));
}

}  // namespace

template <class T>
T draw(const Sight<T>& sight, std::size_t cell, std::uint32_t purpose) {
    return unit_uniform<T>(counted_words(cell, sight.iteration, sight.rule, purpose, sight.seed)[0]);
}

// A whole quantity as numbers of type N.
template <class N, class T>
Column<N> whole_column(const Sight<T>& sight, Quantity quantity) {
    const State<T>& old = sight.old;
    const std::size_t cells = old.cells();
    const std::size_t columns = old.columns == 0 ? 1 : old.columns;
    const std::size_t rows = old.rows == 0 ? 1 : old.rows;
    const std::size_t lattice = old.columns == 0 ? 0 : 1;
    switch (quantity) {
        case Quantity::neighbours:
            return of_each<N>(cells, [&](auto cell) { return old.neighbours[cell]; });
        case Quantity::age:
            return of_each<N>(cells, [&](auto cell) { return sight.iteration - old.birth[cell]; });
        case Quantity::birth:
            return of_each<N>(cells, [&](auto cell) { return old.birth[cell]; });
        case Quantity::row:
            return of_each<N>(cells, [&](auto cell) { return cell / columns % rows * lattice; });
        case Quantity::column:
            return of_each<N>(cells, [&](auto cell) { return cell % columns * lattice; });
        case Quantity::layer:
            return of_each<N>(cells, [&](auto cell) { return cell / columns / rows * lattice; });
        case Quantity::layers:
            return Column<N>(static_cast<N>(old.layers));
        case Quantity::rows:
            return Column<N>(static_cast<N>(old.rows));
        case Quantity::columns:
            return Column<N>(static_cast<N>(old.columns));
        default:
            return Column<N>(static_cast<N>(sight.iteration));
    }
}

template <class T>
Column<T> Sight<T>::column(const Operand& operand) {
    if (is_whole(operand.quantity)) return whole_column<T>(*this, operand.quantity);
    switch (operand.quantity) {
        case Quantity::number:
            return Column<T>(in_precision<T>(operand.value));
        case Quantity::x:
            return Column<T>(old.x);
        case Quantity::y:
            return Column<T>(old.y);
        case Quantity::z: {
            if (!ground.z.empty()) return Column<T>(ground.z);
            const std::vector<double> z = centres(0.0, old.layers);
            const std::size_t layer = old.columns * old.rows;
            return of_each<T>(old.cells(), [&](auto cell) { return z.empty() ? 0.0 : z[cell / layer]; });
        }
        case Quantity::random: {
            const std::uint32_t nth = randoms++;
            const std::uint32_t purpose = purpose::operand + 16 * (nth / 4);
            return of_each<T>(old.cells(), [&](auto cell) {
                return unit_uniform<T>(counted_words(cell, iteration, rule, purpose, seed)[nth % 4]);
            });
        }
        case Quantity::concentration:
            return Column<T>(old.conc[operand.index]);
        case Quantity::rate:
            return Column<T>(old.diff[operand.index]);
        case Quantity::mapping:
            return Column<T>(mappings[operand.index]);
        case Quantity::time:
            return Column<T>(time());
        case Quantity::laplacian:
            return Column<T>(ground.laplacian(old.conc[operand.index]));
        case Quantity::gradient_x:
            return Column<T>(ground.gradient(old.conc[operand.index], Axis::x));
        case Quantity::gradient_y:
            return Column<T>(ground.gradient(old.conc[operand.index], Axis::y));
        case Quantity::gradient_z:
            return Column<T>(ground.gradient(old.conc[operand.index], Axis::z));
        case Quantity::stencil:
            return Column<T>(ground.stencil(experiment.stencils[operand.stencil], old.conc[operand.index]));
        case Quantity::field:
            if (operand.index < ground.fields.size() && !ground.fields[operand.index].empty())
                return Column<T>(ground.fields[operand.index]);
            return computed(std::get<ComputedField>(experiment.fields[operand.index].source).expression);
        case Quantity::expression:
            return computed(experiment.expressions[operand.index]);
        default:
            return Column<T>(T(0));
    }
}

// Experiment::time_at() in the precision of the run: what has passed before the phase, and the steps since.
template <class T>
T Sight<T>::time() const {
    const Phase& phase = experiment.phase_at(iteration);
    return in_precision<T>(experiment.time_at(phase.begin)) +
           static_cast<T>(iteration - phase.begin) * in_precision<T>(phase.time_step);
}

template <class T>
Column<T> Sight<T>::computed(const Expression& expression) {
    const std::vector<ExpressionNode>& nodes = expression.nodes;
    std::vector<Column<T>> columns;
    std::vector<Column<double>> exact;
    columns.reserve(nodes.size());
    exact.reserve(nodes.size());
    Leaves<T> leaves{std::vector<Leaf<T>>(nodes.size()), std::vector<Leaf<double>>(nodes.size())};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const Operand& operand = nodes[n].operand;
        if (nodes[n].operation != Operation::operand) continue;
        leaves.values[n] = columns.emplace_back(column(operand)).leaf();
        if (is_whole(operand.quantity) || operand.quantity == Quantity::number)
            leaves.exact[n] = exact.emplace_back(exact_column(operand)).leaf();
    }
    std::vector<T> values(old.cells());
    evaluate(expression, leaves, values.size(), values.data());
    return Column<T>(std::move(values));
}

template <class T>
Column<double> Sight<T>::exact_column(const Operand& operand) const {
    if (operand.quantity == Quantity::number) return Column<double>(operand.value);
    return whole_column<double>(*this, operand.quantity);
}

template float draw(const Sight<float>&, std::size_t, std::uint32_t);
template double draw(const Sight<double>&, std::size_t, std::uint32_t);
template struct Sight<float>;
template struct Sight<double>;

}  // namespace pelage::reference
