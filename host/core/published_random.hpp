// The generator the published experiments were drawn with: glibc's TYPE_3 additive feedback rand().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pelage {

class PublishedRandom {
public:
    // Seeds that the published program takes, those of 32 bits with a sign, give its numbers. From any other seed all
    // 64 bits enter the generator's first state. Seed 0 counts as 1, as in glibc.
    explicit PublishedRandom(std::int64_t seed = 1);

    std::uint32_t next();                         // 0 .. 2^31 - 1
    float range(float low, float high);           // low + (high - low) * next / (2^31 - 1), in float
    float deviate(float value, float deviation);  // no draw where deviation is 0

private:
    void seed_as_published(std::int32_t seed);
    void seed_by_all_bits(std::uint64_t seed);

    std::array<std::uint32_t, 31> words_{};
    std::size_t front_ = 3;
    std::size_t back_ = 0;
};

}  // namespace pelage
