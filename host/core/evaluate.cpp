// See evaluate.hpp. Cells are taken in blocks that caches hold, node after node.
#include "core/evaluate.hpp"

#include "core/functions.hpp"

#include <algorithm>
#include <array>

namespace pelage {

namespace {

constexpr std::size_t block_size = 256;

template <class T>
using Block = std::array<T, block_size>;

// One node for `count` cells; `a`: its arguments' values.
template <class T>
void compute(const ExpressionNode& node, const T* const* a, std::size_t count, T* out) {
    const auto each = [&](auto&& value) {
        for (std::size_t i = 0; i < count; ++i) out[i] = value(i);
    };
    const auto truth = [](bool b) { return b ? T(1) : T(0); };
    switch (node.operation) {
        case Operation::operand:
            break;
        case Operation::negate:
            return each([&](std::size_t i) { return -a[0][i]; });
        case Operation::add:
            return each([&](std::size_t i) { return a[0][i] + a[1][i]; });
        case Operation::subtract:
            return each([&](std::size_t i) { return a[0][i] - a[1][i]; });
        case Operation::multiply:
            return each([&](std::size_t i) { return a[0][i] * a[1][i]; });
        case Operation::divide:
            return each([&](std::size_t i) { return a[0][i] / a[1][i]; });
        case Operation::compare:
            return each([&](std::size_t i) { return truth(holds(a[0][i], node.comparison, a[1][i])); });
        case Operation::conjunction:
            return each([&](std::size_t i) { return truth(a[0][i] != T(0) && a[1][i] != T(0)); });
        case Operation::disjunction:
            return each([&](std::size_t i) { return truth(a[0][i] != T(0) || a[1][i] != T(0)); });
        case Operation::negation:
            return each([&](std::size_t i) { return truth(a[0][i] == T(0)); });
        case Operation::choice:
            return each([&](std::size_t i) { return a[0][i] != T(0) ? a[1][i] : a[2][i]; });
        case Operation::call:
            return compute_function<T>(node.function, a, count, out);
    }
}

template <class T>
class Blocks {
public:
    Blocks(const Expression& expression, const Leaves<T>& leaves, std::size_t cells)
        : expression_(expression),
          leaves_(leaves),
          blocks_(expression.nodes.size()),
          at_(expression.nodes.size()),
          shared_(expression.nodes.size()) {
        for (std::size_t n = 0; n < blocks_.size(); ++n) {
            at_[n] = blocks_[n].data();
            shared_[n] = of(n).operation == Operation::operand
                             ? leaves_.values[n].values == nullptr
                             : std::ranges::all_of(of(n).arguments, [&](std::size_t i) { return shared_[i]; });
            if (!shared_[n]) continue;
            if (of(n).operation == Operation::operand) blocks_[n].fill(leaves_.values[n].everywhere);
            node(n, 0, std::min(cells, block_size));
        }
    }

    // The values of `count` cells from `first` on.
    const T* take(std::size_t first, std::size_t count) {
        for (std::size_t n = 0; n < blocks_.size(); ++n) {
            if (!shared_[n]) node(n, first, count);
        }
        return at_.back();
    }

private:
    const ExpressionNode& of(std::size_t n) const { return expression_.nodes[n]; }

    void node(std::size_t n, std::size_t first, std::size_t count) {
        const ExpressionNode& node = of(n);
        if (node.operation == Operation::operand) {
            if (leaves_.values[n].values != nullptr) at_[n] = leaves_.values[n].values + first;
            return;
        }
        if (node.operation == Operation::compare && compares_exactly(expression_, node)) {
            const Leaf<double>& left = leaves_.exact[node.arguments[0]];
            const Leaf<double>& right = leaves_.exact[node.arguments[1]];
            for (std::size_t i = 0; i < count; ++i)
                blocks_[n][i] = holds(left.at(first + i), node.comparison, right.at(first + i)) ? T(1) : T(0);
            return;
        }
        arguments_.clear();
        for (const std::size_t argument : node.arguments) arguments_.push_back(at_[argument]);
        compute<T>(node, arguments_.data(), count, blocks_[n].data());
    }

    const Expression& expression_;
    const Leaves<T>& leaves_;
    std::vector<Block<T>> blocks_;
    std::vector<const T*> at_;  // where each node's values lie
    std::vector<const T*> arguments_;
    std::vector<bool> shared_;  // whether a node has the same value for all cells: it is computed once
};

}  // namespace

template <class T>
void evaluate(const Expression& expression, const Leaves<T>& leaves, std::size_t cells, T* out) {
    Blocks<T> blocks(expression, leaves, cells);
    for (std::size_t first = 0; first < cells; first += block_size) {
        const std::size_t count = std::min(block_size, cells - first);
        std::copy_n(blocks.take(first, count), count, out + first);
    }
}

double evaluate_node(const ExpressionNode& node, const std::vector<double>& arguments) {
    std::vector<const double*> places;
    for (const double& argument : arguments) places.push_back(&argument);
    double value = 0.0;
    compute<double>(node, places.data(), 1, &value);
    return value;
}

template void evaluate(const Expression&, const Leaves<float>&, std::size_t, float*);
template void evaluate(const Expression&, const Leaves<double>&, std::size_t, double*);

}  // namespace pelage
