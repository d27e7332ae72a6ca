// See learning.hpp.
#include "core/learning.hpp"

#include "core/error.hpp"
#include "core/neural.hpp"

#include <fmt/format.h>

namespace pelage {

namespace {

// States 0, stride, 2 stride, ... below `iterations`; the last one of all is always at hand.
Keeping with_stride(std::size_t iterations, std::size_t stride) {
    return {stride, (iterations + stride - 1) / stride, stride - 1};
}

void check_range(const char* what, std::size_t value, std::size_t least, std::size_t most, std::size_t multiple) {
    if (value >= least && value <= most && value % multiple == 0) return;
    const std::string multiples = multiple == 1 ? "whole numbers" : fmt::format("multiples of {}", multiple);
    throw Error(fmt::format("{} {} is not allowed; allowed are {} from {} to {}", what, value, multiples, least, most));
}

}  // namespace

Keeping keeping(std::size_t iterations, double bytes, double memory) {
    Keeping least = with_stride(iterations, 1);
    for (std::size_t stride = 1; stride <= iterations; ++stride) {
        const Keeping one = with_stride(iterations, stride);
        if (static_cast<double>(one.states()) * bytes <= memory) return one;
        if (one.states() < least.states()) least = one;
    }
    return least;
}

void check_learning(const LearningShape& shape) {
    check_range("--size", shape.side, 2 * sum_lanes, 512, sum_lanes);
    check_range("--batch", shape.batch, 1, 64, 1);
    check_range("--chemicals", shape.chemicals, chemical_groups, largest_network_chemicals, chemical_groups);
    check_range("--hidden", shape.hidden, hidden_block, largest_hidden, hidden_block);
    check_range("--rotations", shape.rotations, 1, 64, 1);
}

}  // namespace pelage
