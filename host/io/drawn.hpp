// What pictures show of a state: a chemical, or the values of the experiment's expressions.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace pelage {

// The place of the first output of colours, which is STEM.png; their number where there is none.
std::size_t first_of_colours(const std::vector<Output>&);

// Of one output, one value a cell: a single column, or red, green and blue. Columns of chemicals are those of the
// snapshot, which must live longer.
class Drawn {
public:
    // Expressions are computed in double precision from the state. `output`: its place in Experiment::outputs.
    Drawn(const Experiment&, const Output&, std::size_t output, const Snapshot&);
    // Values that have been computed before.
    explicit Drawn(std::vector<double> values);

    Drawn(Drawn&&) = default;
    Drawn& operator=(Drawn&&) = default;
    Drawn(const Drawn&) = delete;
    Drawn& operator=(const Drawn&) = delete;
    ~Drawn() = default;

    std::vector<std::span<const double>> columns() const;
    std::span<const double> values() const { return columns().front(); }

private:
    std::span<const double> of_state_;
    std::vector<std::vector<double>> computed_;
};

}  // namespace pelage
