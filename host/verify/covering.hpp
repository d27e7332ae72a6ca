// Covering arrays: few rows of values in which all values of any two (or three) factors meet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pelage::verify {

struct Factor {
    std::string name;
    std::vector<std::string> values;
};

using ArrayRow = std::vector<std::size_t>;  // the number of a value for each factor

struct Choice {  // one value of one factor
    std::size_t factor = 0;
    std::size_t value = 0;
};

struct Array {
    std::vector<Factor> factors;
    std::size_t strength = 2;  // 2: pairs; 3: triples
    // Whether two values can stand in one row.
    std::function<bool(const Choice&, const Choice&)> feasible;
    // Not empty: values of the first factors are those of one of these rows, whose own tuples count as met already.
    std::vector<ArrayRow> given = {};
    // Which sets of factors are to have all their tuples; empty: every set.
    std::function<bool(const std::vector<std::size_t>&)> wanted = {};
    std::vector<std::size_t> costs = {};  // of each given one: rows begin with those that add most for what they cost
    std::uint64_t draw =
        0;  // not 0: factors take their values in an order drawn with this seed, which may need fewer rows
};

struct Covering {
    std::vector<ArrayRow> rows;
    std::vector<std::size_t> of_given;  // for each row, which of the given ones it begins with
    std::size_t infeasible = 0;         // tuples that no row can hold
};

// Greedy, and the same on every machine: the first tuple that has not been met begins a row, and each factor in turn
// takes the value with which most new tuples meet. Rows that later ones made superfluous are dropped.
Covering cover(const Array&);

// All tuples of values that no row of these holds, as text, though any two of them may stand in one row and each other
// factor has a value that may stand beside them: for tests. Rows may be shorter: their last factors are open then.
std::vector<std::string> not_met(const Array&, const std::vector<ArrayRow>& rows);

}  // namespace pelage::verify
