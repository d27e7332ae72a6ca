// Random numbers: known answers of both generators, and the uniformity of the counted one.
#include "core/philox.hpp"
#include "core/published_random.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

using namespace pelage;

TEST_CASE("Philox4x32-10 gives the published known answers") {
    using Words = std::array<std::uint32_t, 4>;
    const std::uint32_t ones = 0xffffffffu;

    CHECK(philox4x32_10({0, 0, 0, 0}, {0, 0}) == Words{0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u});
    CHECK(philox4x32_10({ones, ones, ones, ones}, {ones, ones}) ==
          Words{0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu});
    CHECK(philox4x32_10({0x243f6a88u, 0x85a308d3u, 0x13198a2eu, 0x03707344u}, {0xa4093822u, 0x299f31d0u}) ==
          Words{0xd16cfe09u, 0x94fdccebu, 0x5001e420u, 0x24126ea1u});
}

TEST_CASE("unit_uniform lies in 0 to 1 and fills it evenly") {
    constexpr std::size_t draws = 160000, bins = 16;
    std::array<double, bins> counts{};

    for (std::uint32_t i = 0; i < draws; ++i) {
        const auto u = unit_uniform<float>(philox4x32_10({i, 7, 3, 0}, {42, 0})[0]);
        REQUIRE(u >= 0.0f);
        REQUIRE(u < 1.0f);
        counts[static_cast<std::size_t>(u * bins)] += 1;
    }

    double chi2 = 0.0;
    for (const double count : counts) chi2 += (count - draws / bins) * (count - draws / bins) / (draws / bins);
    CHECK(chi2 < 37.7);  // 15 degrees of freedom, p = 0.001
    CHECK(unit_uniform<float>(0xffffffffu) < 1.0f);
    CHECK(static_cast<double>(unit_uniform<float>(0x12345678u)) == unit_uniform<double>(0x12345678u));
}

TEST_CASE("the published generator is glibc's rand") {
    PublishedRandom random(1);
    PublishedRandom other(42);

    const std::vector<std::uint32_t> first{random.next(), random.next(), random.next()};

    CHECK(first == std::vector<std::uint32_t>{1804289383u, 846930886u, 1681692777u});
    CHECK(other.next() == 71876166u);
    CHECK(other.next() == 708592740u);
}

TEST_CASE("seeds that the published program takes keep its numbers, of all others every bit counts") {
    const auto first = [](std::int64_t seed) {
        PublishedRandom random(seed);
        std::vector<std::uint32_t> drawn;
        for (int i = 0; i < 40; ++i) drawn.push_back(random.next());
        return drawn;
    };

    // By glibc's srand(seed), rand().
    CHECK(first(2147483647)[0] == 1065668062u);
    CHECK(first(-1)[0] == 254925627u);
    CHECK(first(-2147483648)[0] == 1336741213u);
    std::set<std::vector<std::uint32_t>> starts;
    std::vector<std::int64_t> seeds{1,
                                    2147483647,
                                    2147483648,
                                    4294967295,
                                    4294967296,
                                    4294967297,
                                    -1,
                                    -2147483648,
                                    -2147483649,
                                    std::numeric_limits<std::int64_t>::max(),
                                    std::numeric_limits<std::int64_t>::min()};
    for (int bit = 31; bit < 63; ++bit) seeds.push_back((std::int64_t{1} << bit) + 5);
    for (const std::int64_t seed : seeds) starts.insert(first(seed));
    CHECK(starts.size() == seeds.size());
    for (const auto& drawn : starts) {
        CHECK(std::ranges::all_of(drawn, [](std::uint32_t word) { return word < 1u << 31; }));
    }
}

TEST_CASE("a deviation of 0 draws nothing") {
    PublishedRandom random(5), same(5);

    CHECK(random.deviate(3.5f, 0.0f) == 3.5f);
    CHECK(random.next() == same.next());
    const float drawn = random.deviate(4.0f, 2.0f);
    CHECK(drawn >= 2.0f);
    CHECK(drawn <= 6.0f);
}
