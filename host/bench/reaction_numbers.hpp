// What the baselines by hand take from an experiment's first rule, a reaction of two chemicals.
#pragma once

#include "bench/openmp_rows.hpp"
#include "core/experiment.hpp"
#include "core/subnormal.hpp"

#include <variant>

namespace pelage::bench {

// In single precision, subnormal numbers being zero: call it while a SubnormalsAreZero lives.
inline ReactionNumbers reaction_numbers(const Experiment& experiment) {
    const React& react = std::get<React>(experiment.rules.front().action);
    ReactionNumbers numbers;
    numbers.sdt = in_precision<float>(react.scale.value) * in_precision<float>(experiment.phases.front().time_step);
    for (std::size_t i = 0; i < 2; ++i) numbers.p[i] = in_precision<float>(react.parameters[i].value);
    return numbers;
}

}  // namespace pelage::bench
