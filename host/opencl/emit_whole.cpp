// See emit_whole.hpp.
#include "opencl/emit_whole.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace pelage {

namespace {

constexpr double largest = std::numeric_limits<std::uint32_t>::max();

std::string constant(bool truth) { return truth ? "ALL_TRUE" : "ALL_FALSE"; }

// `limit` is a whole number.
std::string test(const std::string& whole, Comparison comparison, double limit) {
    return fmt::format("TO_MASK({} {} W({}u))", whole, symbol(comparison), static_cast<std::uint32_t>(limit));
}

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

std::string emit_whole_test(const std::string& whole, Comparison comparison, double number) {
    const double below = std::floor(number);
    const double above = std::ceil(number);
    switch (comparison) {
        case Comparison::equal:
        case Comparison::not_equal: {
            const bool possible = below == above && below >= 0.0 && below <= largest;
            return possible ? test(whole, comparison, below) : constant(comparison == Comparison::not_equal);
        }
        case Comparison::less:
        case Comparison::greater_equal: {  // of w and number as of w and the next whole number above it
            if (above <= 0.0) return constant(comparison == Comparison::greater_equal);
            if (above > largest) return constant(comparison == Comparison::less);
            return test(whole, comparison, above);
        }
        case Comparison::less_equal:
        case Comparison::greater: {
            if (below < 0.0) return constant(comparison == Comparison::greater);
            if (below >= largest) return constant(comparison == Comparison::less_equal);
            return test(whole, comparison, below);
        }
    }
    return constant(false);
}

}  // namespace pelage
