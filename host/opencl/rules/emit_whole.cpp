// See emit_whole.hpp.
#include "opencl/rules/emit_whole.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pelage {

namespace {

constexpr double largest = std::numeric_limits<std::uint32_t>::max();

constexpr WholeRange no_range{1, 0, true};

// Up to the largest whole number that is not above `limit`.
WholeRange up_to(double limit) {
    if (limit < 0.0) return no_range;
    return {0, static_cast<std::uint32_t>(std::min(limit, largest)), true};
}

WholeRange others(WholeRange range) { return {range.low, range.high, false}; }

}  // namespace

const char* symbol(Comparison comparison) {
    switch (comparison) {
        case Comparison::equal:
            return "==";
        case Comparison::not_equal:
            return "!=";
        case Comparison::less:
            return "<";
        case Comparison::less_equal:
            return "<=";
        case Comparison::greater:
            return ">";
        case Comparison::greater_equal:
            return ">=";
    }
    return "==";
}

Comparison exchanged(Comparison comparison) {
    switch (comparison) {
        case Comparison::less:
            return Comparison::greater;
        case Comparison::less_equal:
            return Comparison::greater_equal;
        case Comparison::greater:
            return Comparison::less;
        case Comparison::greater_equal:
            return Comparison::less_equal;
        default:
            return comparison;
    }
}

WholeRange whole_range(Comparison comparison, double number) {
    const double below = std::floor(number);
    const double above = std::ceil(number);
    const bool whole = below == above && below >= 0.0 && below <= largest;
    const auto exactly = static_cast<std::uint32_t>(whole ? below : 0.0);
    switch (comparison) {
        case Comparison::equal:
            return whole ? WholeRange{exactly, exactly, true} : no_range;
        case Comparison::not_equal:
            return others(whole_range(Comparison::equal, number));
        case Comparison::less:
            return up_to(above - 1.0);
        case Comparison::greater_equal:
            return others(up_to(above - 1.0));
        case Comparison::less_equal:
            return up_to(below);
        case Comparison::greater:
            return others(up_to(below));
    }
    return no_range;
}

std::string emit_whole_test(const std::string& whole, bool uniform, Comparison comparison, double number,
                            Numbers& numbers) {
    const WholeRange range = whole_range(comparison, number);
    const std::string low = numbers.word(range.low);
    const std::string high = numbers.word(range.high);
    if (uniform)
        return fmt::format("UNIFORM({0}(({1} >= {2}) && ({1} <= {3})))", range.inside ? "" : "!", whole, low, high);
    return fmt::format("{0}TO_MASK(({1} >= W({2})) & ({1} <= W({3})))", range.inside ? "" : "!", whole, low, high);
}

}  // namespace pelage
