// What charges far away add to a sum: kept at the nodes of blocks, and interpolated. As kernels/aggregate/far_field.cl,
// bit for bit: no operation here is a fused one.
#pragma once

#include "core/far_grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage::reference {

struct FarCharge {
    std::int32_t x = 0, y = 0;
    float size = 1.0f;
};

// The values of the polynomials that are 1 at one node and 0 at all others.
using FarBasis = std::array<float, far_nodes>;

// At a place between 0 and 1, the ends of a block.
FarBasis far_basis(double place);

class FarField {
public:
    FarField() = default;
    explicit FarField(FarGrid grid);

    // Every block that is to keep a charge takes it in.
    void add(const FarCharge&);

    // Sum of size / r over the charges that are not in the site's leaf or beside it, in parts.
    std::int64_t at(std::int32_t x, std::int32_t y) const;

    const FarGrid& grid() const { return grid_; }

private:
    using Values = std::array<float, far_coefficients>;

    void add_to(std::size_t level, std::int32_t column, std::int32_t row, const FarCharge&);
    Values at_nodes_of_leaf(std::size_t column, std::size_t row) const;

    FarGrid grid_;
    std::vector<std::array<std::int64_t, far_coefficients>> sums_;  // row by row of nodes
    std::array<float, far_nodes> nodes_{};
    std::array<std::array<FarBasis, far_nodes>, 2> halves_{};  // at the nodes of a lower and an upper half
    std::vector<FarBasis> places_;                             // of a leaf's columns, and of its rows
};

}  // namespace pelage::reference
