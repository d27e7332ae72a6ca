// The values of an expression for many cells at once.
#pragma once

#include "core/expression.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

// What an operand is for each cell: read in place, or the same for all.
template <class T>
struct Leaf {
    const T* values = nullptr;  // [cell]
    T everywhere{};             // where there are no values

    T at(std::size_t cell) const { return values == nullptr ? everywhere : values[cell]; }
};

// One entry a node of the expression; of nodes that are no operand they are not looked at.
template <class T>
struct Leaves {
    std::vector<Leaf<T>> values;
    std::vector<Leaf<double>> exact;  // of operands that compares_exactly() compares
};

// out[cell] = the expression's value, in T: float or double. In float the caller sees to subnormal numbers
// (SubnormalsAreZero).
template <class T>
void evaluate(const Expression&, const Leaves<T>&, std::size_t cells, T* out);

// The value of a node whose arguments are these numbers; it is no operand.
double evaluate_node(const ExpressionNode&, const std::vector<double>& arguments);

}  // namespace pelage
