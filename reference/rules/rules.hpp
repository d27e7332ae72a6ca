// Carries out the rules of one iteration for every cell of any tissue: lattice or free.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "reference/rules/ground.hpp"
#include "reference/rules/state.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage::reference {

// A `set` to be carried out later, for each cell; empty where no active rule sets the chemical.
template <class T>
struct Remembered {
    std::vector<T> value;
    std::vector<std::uint8_t> present;

    bool empty() const { return present.empty(); }
    void prepare(std::size_t cells);
};

struct Division {  // asked for by a `divide` rule
    std::size_t cell = 0;
    std::size_t rule = 0;  // place in Experiment::rules
    double degrees = 0.0;  // relative to the old polarity, deviation included; rounded to the precision of the run
};

// What rules ask of the rest of the iteration.
template <class T>
struct Requests {
    std::vector<Remembered<T>> set_conc;  // [chemical]: due after diffusion, before the bounds
    std::vector<std::int32_t> polarize;   // [cell]: chemical whose gradient to follow, -1: none; empty: no active rule
    std::vector<Division> divisions;      // rule by rule, cells ascending; not judged by the division limit
    std::vector<std::uint8_t> truth;      // [cell], working space
};

// One iteration's rules, in file order, each for all cells. Every condition and operand reads `old`; `next` holds a
// copy of it and receives reactions, changes of concentration and rate, rates that are set, mappings, and in x and y
// the steps of `move` (along the old polarity). dt is that of the iteration's phase.
template <class T>
void apply_rules(const Experiment&, std::uint64_t iteration, Arithmetic, const Ground<T>&, const State<T>& old,
                 State<T>& next, Requests<T>&);

}  // namespace pelage::reference
