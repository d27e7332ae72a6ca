// What the cells of one lattice hold that the device need not know.
#pragma once

#include "core/snapshot.hpp"
#include "opencl/lattice/kept_field.hpp"

#include <cstdint>
#include <optional>

namespace pelage {

struct KeptCells {
    KeptField<double> polarity_x, polarity_y;
    KeptField<std::uint32_t> birth;
    KeptField<std::int32_t> neighbours;
    KeptField<std::uint8_t> fixed;
    decltype(Snapshot::mirrors) mirrors;

    // `born`: when the duplicates are, where birth is kept here.
    void insert(const Grid& grid, const Insertion& insertion, std::optional<std::uint32_t> born) {
        polarity_x.insert(grid, insertion);
        polarity_y.insert(grid, insertion);
        if (born) birth.insert(grid, insertion, born);
        neighbours.insert(grid, insertion);
        fixed.insert(grid, insertion);
    }

    void stretch(const Grid& grid, const Resampling& to) {
        polarity_x.stretch(grid, to);
        polarity_y.stretch(grid, to);
        birth.stretch(grid, to);
        neighbours.stretch(grid, to);
        fixed.stretch(grid, to);
    }
};

}  // namespace pelage
