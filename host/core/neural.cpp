// See neural.hpp.
#include "core/neural.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace pelage {

namespace {

void check_network_size(std::size_t chemicals, std::size_t hidden, const std::string& name) {
    if (chemicals == 0 || chemicals % chemical_groups != 0 || chemicals > largest_network_chemicals)
        throw Error(fmt::format("'{}' is a network of {} chemicals; allowed are multiples of {} up to {}", name,
                                chemicals, chemical_groups, largest_network_chemicals));
    if (hidden == 0 || hidden > largest_hidden)
        throw Error(
            fmt::format("'{}' is a network of {} hidden values; allowed are 1 to {}", name, hidden, largest_hidden));
}

void check_weights(const std::vector<double>& values, std::size_t wanted, const char* which, const std::string& name) {
    if (values.size() != wanted)
        throw Error(fmt::format("'{}' has {} numbers in {}; {} are needed", name, values.size(), which, wanted));
    for (const double value : values) {
        if (std::isfinite(static_cast<float>(value))) continue;
        throw Error(
            fmt::format("'{}' holds {} in {}; every weight must be a number that float can hold", name, value, which));
    }
}

}  // namespace

Network make_network(std::size_t chemicals, std::size_t hidden, const std::vector<double>& first,
                     const std::vector<double>& bias, const std::vector<double>& second, const std::string& name) {
    check_network_size(chemicals, hidden, name);
    check_weights(first, chemicals * hidden, "W0", name);
    check_weights(bias, hidden, "b0", name);
    check_weights(second, hidden * chemicals, "W1", name);
    Network network;
    network.chemicals = chemicals;
    network.hidden = (hidden + hidden_block - 1) / hidden_block * hidden_block;
    network.first.assign(chemicals * network.hidden, 0.0);
    for (std::size_t i = 0; i < chemicals; ++i) {
        for (std::size_t h = 0; h < hidden; ++h) network.first[i * network.hidden + h] = first[i * hidden + h];
    }
    network.bias = bias;
    network.bias.resize(network.hidden, 0.0);
    network.second = second;
    network.second.resize(network.hidden * chemicals, 0.0);
    return network;
}

double group_rate(std::size_t place, std::size_t chemicals) {
    static constexpr std::array<double, chemical_groups> rates{0.125, 0.25, 0.5, 1.0};
    return rates[place * chemical_groups / chemicals];
}

}  // namespace pelage
