// The parameters of rules, seen as one number a cell.
#pragma once

#include "core/evaluate.hpp"
#include "core/experiment.hpp"
#include "reference/rules/ground.hpp"
#include "reference/rules/state.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage::reference {

// A value for every cell: read in place, computed once, or the same for all.
template <class T>
class Column {
public:
    explicit Column(T everywhere) : everywhere_(everywhere) {}
    explicit Column(const std::vector<T>& in_place) : data_(in_place.data()) {}
    explicit Column(std::vector<T>&& computed) : computed_(std::move(computed)), data_(computed_.data()) {}
    Column(Column&&) noexcept = default;  // a moved vector keeps its storage
    Column& operator=(Column&&) = delete;

    T operator[](std::size_t cell) const { return data_ == nullptr ? everywhere_ : data_[cell]; }
    bool constant() const { return data_ == nullptr; }
    Leaf<T> leaf() const { return {data_, everywhere_}; }

private:
    std::vector<T> computed_;
    const T* data_ = nullptr;
    T everywhere_{};
};

// What a rule sees while it acts: the state before the iteration, and mappings as rules before it have left them.
template <class T>
struct Sight {
    const Experiment& experiment;
    const State<T>& old;
    const std::vector<std::vector<T>>& mappings;
    const Ground<T>& ground;
    std::uint64_t iteration;
    std::int64_t seed;
    std::size_t rule;           // place in Experiment::rules
    std::uint32_t randoms = 0;  // RANDOM operands of this rule read so far

    // Reads operands in the order of the rule: condition first, then the action's in order of declaration.
    Column<T> column(const Operand&);

    // A whole quantity or a written number, for comparisons: in double, which rounds neither.
    Column<double> exact_column(const Operand&) const;

private:
    Column<T> computed(const Expression&);
    T time() const;
};

// The first word of the draw that belongs to (cell, iteration, rule, purpose), as a number in [0, 1).
template <class T>
T draw(const Sight<T>&, std::size_t cell, std::uint32_t purpose);

}  // namespace pelage::reference
