// Populations far past the first buffers.
#pragma once

#include "support/free_cells.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace test {

// Divides two cells until there are so many; none is lost or doubled.
inline void check_growth_from_two(std::size_t cells) {
    const auto tissue = on_device(experiment(R"(
define chemical A
define domain 3000 3000
define division_limit 9
use chemical A conc 1 diff 0.1
create cell 0 0
create cell 2 0
rule probability 0.2 divide direction 0 dev 180
)"));

    std::size_t before = 2;
    while (tissue->cells() < cells) {
        tissue->advance(20);
        REQUIRE(tissue->cells() >= before);
        before = tissue->cells();
    }

    const pelage::Snapshot state = tissue->read();  // reading checks that every id is there once
    CHECK(state.cells() == tissue->cells());
    // Ids are given in order of birth, and A is neither made nor lost but by division, which copies it.
    CHECK(std::is_sorted(state.birth.begin(), state.birth.end()));
    CHECK(std::ranges::all_of(state.conc[0], [](double value) { return value == 1; }));
    CHECK(std::ranges::all_of(state.x, [](double x) { return std::abs(x) <= 1500; }));
    CHECK(std::ranges::all_of(state.fixed, [](std::uint8_t fixed) { return fixed == 0; }));
}

}  // namespace test
