// Division of free cells: who divides, in which direction, and what the child is like.
#pragma once

#include "reference/rules/rules.hpp"
#include "reference/rules/state.hpp"

#include <array>
#include <vector>

namespace pelage::reference {

// (sine, cosine) of an angle in degrees by a fixed polynomial, odd and even of degree 9 and 10 about the nearest
// multiple of a quarter turn: the library's own differ between machines. Error below 1e-6.
template <class T>
std::array<T, 2> sine_cosine(T degrees);

// Keeps the divisions of cells that the limit lets divide, ordered by (cell, rule). 0: no limit.
template <class T>
void judge_divisions(std::vector<Division>&, const State<T>& old, std::size_t division_limit);

// Appends the children, in the order given, to `next`: all of the parent's old state, one radius away in the
// division's direction, which becomes the child's polarity; not fixed. Throws Error past largest_cell_count.
template <class T>
void append_children(const std::vector<Division>&, std::uint64_t iteration, const State<T>& old, State<T>& next);

}  // namespace pelage::reference
