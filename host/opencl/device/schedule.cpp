// See schedule.hpp.
#include "opencl/device/schedule.hpp"

#include "core/error.hpp"
#include "opencl/device/program.hpp"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace pelage {

namespace {

constexpr std::string_view drawn = "random:";

std::optional<std::uint32_t> seed_of(const std::string& words) {
    if (!words.starts_with(drawn)) return {};
    std::uint32_t seed = 0;
    const char* const end = words.data() + words.size();
    const auto [rest, failure] = std::from_chars(words.data() + drawn.size(), end, seed);
    if (failure != std::errc() || rest != end) return {};
    return seed;
}

}  // namespace

std::string schedule() {
    const char* const words = std::getenv("PELAGE_SCHEDULE");
    return words == nullptr ? "" : words;
}

std::string scheduled(const std::string& source) {
    const std::string words = schedule();
    if (words.empty()) return source;
    const auto seed = seed_of(words);
    if (!seed && words != "reverse") {
        throw Error("PELAGE_SCHEDULE is '" + words +
                    "'; it may be 'reverse', or 'random:' and a whole number from 0 to 4294967295");
    }
    const std::string settings = "#define PELAGE_SEED " + std::to_string(seed.value_or(0)) + "u\n";
    return settings + (seed ? "" : "#define PELAGE_REVERSED\n") + kernel_text("common/schedule.cl") + "#line 1\n" +
           source;
}

}  // namespace pelage
