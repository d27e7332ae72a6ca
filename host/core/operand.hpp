// What stands where a rule takes a number, and how two such values are compared.
#pragma once

#include <cstddef>

namespace pelage {

enum class Quantity {
    number,      // Operand::value
    neighbours,  // as counted in the previous iteration; 0 at iteration 0 and for a newborn cell
    age,
    birth,
    x,
    y,
    z,  // of a volume, 0 in its middle
    row,
    column,
    layer,  // of a volume
    rows,
    columns,
    layers,
    iteration,
    time,           // Experiment::time_at() the iteration
    random,         // uniform in [0, 1), a fresh draw for each cell, iteration and place in the file
    concentration,  // of chemical Operand::index
    rate,           // diffusion rate of chemical Operand::index
    mapping,        // mapping Operand::index
    laplacian,      // of chemical Operand::index; see docs/language.md
    gradient_x,
    gradient_y,
    gradient_z,
    stencil,    // Experiment::stencils[Operand::stencil] over the cells around, of chemical Operand::index
    field,      // Experiment::fields[Operand::index]
    expression  // Experiment::expressions[Operand::index]
};

// Whole numbers from 0 to largest_iteration. Compared with each other and with written numbers they are exact, in any
// precision; everywhere else they are rounded to the precision of the run.
constexpr bool is_whole(Quantity quantity) {
    switch (quantity) {
        case Quantity::neighbours:
        case Quantity::age:
        case Quantity::birth:
        case Quantity::row:
        case Quantity::column:
        case Quantity::layer:
        case Quantity::rows:
        case Quantity::columns:
        case Quantity::layers:
        case Quantity::iteration:
            return true;
        default:
            return false;
    }
}

struct Operand {
    Quantity quantity = Quantity::number;
    double value = 0.0;
    std::size_t index = 0;
    std::size_t stencil = 0;  // of Quantity::stencil alone

    static Operand number(double v) { return {Quantity::number, v, 0}; }
    static Operand concentration(std::size_t chemical) { return {Quantity::concentration, 0.0, chemical}; }
    static Operand rate(std::size_t chemical) { return {Quantity::rate, 0.0, chemical}; }
    bool operator==(const Operand&) const = default;
};

enum class Comparison { equal, not_equal, less, less_equal, greater, greater_equal };

// left COMPARISON right
template <class T>
constexpr bool holds(T left, Comparison comparison, T right) {
    switch (comparison) {
        case Comparison::equal:
            return left == right;
        case Comparison::not_equal:
            return left != right;
        case Comparison::less:
            return left < right;
        case Comparison::less_equal:
            return left <= right;
        case Comparison::greater:
            return left > right;
        case Comparison::greater_equal:
            return left >= right;
    }
    return false;
}

// Truth where the two are compared exactly: a whole quantity with another one or with a written number.
constexpr bool compared_exactly(const Operand& a, const Operand& b) {
    const bool whole_a = is_whole(a.quantity), whole_b = is_whole(b.quantity);
    return (whole_a && (whole_b || b.quantity == Quantity::number)) || (whole_b && a.quantity == Quantity::number);
}

}  // namespace pelage
