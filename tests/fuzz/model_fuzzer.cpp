// Fuzzer of the readers of models: any bytes must give a network whose arrays are whole and finite, or an Error that
// names the file.
#include "core/error.hpp"
#include "io/network.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

void check(const pelage::Network& network) {
    const std::size_t both = network.chemicals * network.hidden;
    if (both == 0 || network.bias.size() != network.hidden) std::abort();
    if (network.first.size() != both || network.second.size() != both) std::abort();
    for (const auto* numbers : {&network.first, &network.bias, &network.second}) {
        for (const double number : *numbers) {
            if (!std::isfinite(number)) std::abort();
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        check(pelage::parse_network({reinterpret_cast<const char*>(data), size}, "fuzz.model"));
    } catch (const pelage::Error& error) {
        if (std::string_view(error.what()).find("fuzz.model") == std::string_view::npos) std::abort();
    }
    return 0;
}
