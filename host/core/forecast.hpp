// What can be told of a run before it is carried out.
#pragma once

#include "core/experiment.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace pelage {

struct LatticeSize {  // double: absurd sizes must not overflow
    double columns = 0;
    double rows = 0;
};

// Of a matrix after `last` iterations, expansions included; nothing for other tissues.
std::optional<LatticeSize> final_size(const Experiment&, std::uint64_t last);

// Cells of any tissue then.
double final_cells(const Experiment&, std::uint64_t last);

// The first iteration from which on this set of rules, active at `iteration`, cannot be the active one again because a
// rule has ended or another one has begun for good; forever when there is none. Expansions do not count.
std::uint64_t end_of_set(const Experiment&, const std::vector<bool>& active, std::uint64_t iteration);

}  // namespace pelage
