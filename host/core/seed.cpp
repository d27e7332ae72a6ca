// See seed.hpp.
#include "core/seed.hpp"

#include "core/philox.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <variant>

namespace pelage {

std::int64_t seed_from_clock() {
    static std::atomic<std::uint32_t> calls{0};
    const auto now = static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
    const auto process = static_cast<std::uint32_t>(getpid());
    const std::array<std::uint32_t, 4> words = philox4x32_10(
        {static_cast<std::uint32_t>(now), static_cast<std::uint32_t>(now >> 32), calls++, process}, {0, 0});
    const std::uint64_t drawn = (std::uint64_t{words[0]} << 32 | words[1]) >> 11;
    return static_cast<std::int64_t>(std::max<std::uint64_t>(drawn, 1));
}

bool seeded_by_clock(const Experiment& experiment) {
    if (experiment.seed) return *experiment.seed == 0;
    return std::ranges::any_of(experiment.prepattern, [](const Statement& statement) {
        const auto* use = std::get_if<UseSeed>(&statement);
        return use != nullptr && use->seed == 0;
    });
}

void settle_seed(Experiment& experiment, std::int64_t seed) {
    if (seeded_by_clock(experiment)) experiment.seed = seed;
}

}  // namespace pelage
