// See digits.hpp.
#include "core/digits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace pelage {

std::string digits(double value) {
    std::string whole = fmt::format("{}", value);
    if (std::fabs(value) > double{std::numeric_limits<float>::max()}) return whole;
    const auto single = static_cast<float>(value);
    if (static_cast<double>(single) != value) return whole;
    std::string brief = fmt::format("{}", single);
    return brief.size() < whole.size() ? brief : whole;
}

}  // namespace pelage
