// See learning.hpp.
#include "core/learning.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace pelage {

namespace {

// States 0, stride, 2 stride, ... below `iterations`; the last one of all is always at hand.
Keeping with_stride(std::size_t iterations, std::size_t stride) {
    return {stride, (iterations + stride - 1) / stride, stride - 1};
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

std::string allowed(const WholeLimit& limit) {
    const std::string kind = limit.multiple == 1 ? "whole number" : fmt::format("multiple of {}", limit.multiple);
    return fmt::format("a {} from {} to {}", kind, limit.least, limit.most);
}

void check_limit(const WholeLimit& limit, std::uint64_t value) {
    if (limit.allows(value)) return;
    throw Error(fmt::format("{} {} is not allowed; allowed is {}", limit.option, value, allowed(limit)));
}

void check_learning(const LearningShape& shape) {
    check_limit(learning_limits::size, shape.side);
    check_limit(learning_limits::batch, shape.batch);
    check_limit(learning_limits::chemicals, shape.chemicals);
    check_limit(learning_limits::hidden, shape.hidden);
    check_limit(learning_limits::rotations, shape.rotations);
}

}  // namespace pelage
