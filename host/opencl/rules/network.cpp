// See network.hpp.
#include "opencl/rules/network.hpp"

#include <cstddef>

namespace pelage {

std::vector<double> network_table(const Network& network) {
    std::vector<double> table;
    table.reserve(network.hidden * (2 * network.chemicals + 1));
    for (std::size_t begin = 0; begin < network.hidden; begin += hidden_block) {
        const std::size_t end = begin + hidden_block;
        for (std::size_t h = begin; h < end; ++h) table.push_back(network.bias[h]);
        for (std::size_t i = 0; i < network.chemicals; ++i) {
            for (std::size_t h = begin; h < end; ++h) table.push_back(network.first[i * network.hidden + h]);
        }
        for (std::size_t i = 0; i < network.chemicals; ++i) {
            for (std::size_t h = begin; h < end; ++h) table.push_back(network.second[h * network.chemicals + i]);
        }
    }
    return table;
}

}  // namespace pelage
