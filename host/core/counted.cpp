// See counted.hpp.
#include "core/counted.hpp"

#include <cstddef>

namespace pelage {

std::string grouped(std::uint64_t number) {
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string noun(std::uint64_t number, std::string_view one, std::string_view many) {
    if (number == 1) return std::string(one);
    return many.empty() ? std::string(one) + "s" : std::string(many);
}

std::string counted(std::uint64_t number, std::string_view one, std::string_view many) {
    return grouped(number) + " " + noun(number, one, many);
}

}  // namespace pelage
