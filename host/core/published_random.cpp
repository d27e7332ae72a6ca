// See published_random.hpp.
#include "core/published_random.hpp"

#include "core/philox.hpp"

#include <limits>

namespace pelage {

PublishedRandom::PublishedRandom(std::int64_t seed) {
    using Published = std::numeric_limits<std::int32_t>;
    if (seed >= Published::min() && seed <= Published::max()) {
        seed_as_published(static_cast<std::int32_t>(seed));
    } else {
        seed_by_all_bits(static_cast<std::uint64_t>(seed));
    }
    for (int i = 0; i < 310; ++i) next();
}

void PublishedRandom::seed_as_published(std::int32_t seed) {
    std::int64_t word = seed == 0 ? 1 : seed;
    for (std::uint32_t& slot : words_) {
        slot = static_cast<std::uint32_t>(word);
        word = 16807 * word % 2147483647;  // Lehmer's rule, kept positive
        if (word < 0) word += 2147483647;
    }
}

void PublishedRandom::seed_by_all_bits(std::uint64_t seed) {
    const std::array<std::uint32_t, 2> key{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
    for (std::uint32_t i = 0; i < words_.size(); ++i) words_[i] = philox4x32_10({i, 0, 0, 0}, key)[0];
    words_[0] |= 1u;  // were all words even, all sums would be
}

std::uint32_t PublishedRandom::next() {
    words_[front_] += words_[back_];
    const std::uint32_t drawn = words_[front_] >> 1;
    front_ = (front_ + 1) % words_.size();
    back_ = (back_ + 1) % words_.size();
    return drawn;
}

float PublishedRandom::range(float low, float high) {
    return low + (high - low) * (static_cast<float>(next()) / 2147483647.0f);
}

float PublishedRandom::deviate(float value, float deviation) {
    return deviation == 0.0f ? value : range(value - deviation, value + deviation);
}

}  // namespace pelage
