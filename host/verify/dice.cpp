// See dice.hpp.
#include "verify/dice.hpp"

#include "core/philox.hpp"

#include <fmt/format.h>

#include <numeric>

namespace pelage::verify {

std::uint32_t Dice::word() {
    const std::uint64_t place = drawn_++;
    return philox4x32_10({static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(place >> 32), 0x70656c61u, 0u},
                         {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)})[0];
}

std::size_t Dice::below(std::size_t count) {
    return static_cast<std::size_t>((std::uint64_t{word()} * static_cast<std::uint64_t>(count)) >> 32);
}

double Dice::real(double low, double high) { return low + (high - low) * (static_cast<double>(below(1025)) / 1024.0); }

std::size_t Dice::weighted(std::initializer_list<unsigned> weights) {
    std::size_t left = below(std::accumulate(weights.begin(), weights.end(), std::size_t{0}));
    std::size_t place = 0;
    for (const unsigned weight : weights) {
        if (left < weight) break;
        left -= weight;
        ++place;
    }
    return place;
}

std::string Dice::number(double value) {
    std::string text = fmt::format("{}", value);  // the shortest text that reads back to the same double
    switch (weighted({90, 4, 3, 3})) {
        case 1:
            return fmt::format("{:.16e}", value);
        case 2:
            return value >= 0.0 && text.front() != '-' ? "+" + text : text;
        case 3:
            return text.starts_with("0.") ? text.substr(1) : text;
        default:
            return text;
    }
}

}  // namespace pelage::verify
