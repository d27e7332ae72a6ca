// Who is whose neighbour on a lattice, worked by hand on 3 x 2 cells: 0 1 2 below 3 4 5.
#include "core/adjacency.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace pelage;

namespace {

using Cells = std::vector<std::uint32_t>;
constexpr std::uint32_t nobody = Adjacency::nobody;

LatticeAdjacency made(Boundary boundary, Stencil stencil, Arithmetic arithmetic = Arithmetic::fused) {
    Lattice lattice;
    lattice.columns = 3;
    lattice.rows = 2;
    lattice.boundary = boundary;
    lattice.stencil = stencil;
    lattice.arithmetic = arithmetic;
    return lattice_adjacency(lattice);
}

Cells of(const Adjacency& adjacency, std::size_t cell) {
    const auto at = [&](std::size_t i) { return adjacency.indices.begin() + static_cast<std::ptrdiff_t>(i); };
    return {at(adjacency.offsets[cell]), at(adjacency.offsets[cell + 1])};
}

}  // namespace

TEST_CASE("adjacency: neighbours in order, from below upwards and from left to right") {
    const auto open = made(Boundary::no_flux, Stencil::nine_point);
    CHECK(open.cells() == 6);
    CHECK(of(open, 0) == Cells{1, 3, 4});
    CHECK(of(open, 4) == Cells{0, 1, 2, 3, 5});
    const auto torus = made(Boundary::wrap, Stencil::moore);
    CHECK(of(torus, 0) == Cells{5, 3, 4, 2, 1, 5, 3, 4});
    const auto absorbing = made(Boundary::absorbing, Stencil::five_point);
    CHECK(of(absorbing, 0) == Cells{nobody, nobody, 1, 3});
    CHECK(of(absorbing, 5) == Cells{2, 4, nobody, nobody});
}

TEST_CASE("adjacency: the published program begins and ends at an edge with other rows") {
    const auto open = made(Boundary::no_flux, Stencil::moore, Arithmetic::published);
    CHECK(of(open, 1) == Cells{3, 4, 5, 0, 2});  // the bottom row takes its own last
    CHECK(of(open, 4) == Cells{3, 5, 0, 1, 2});  // the top row takes its own first
}

TEST_CASE("adjacency: weights and directions belong to the entries") {
    const auto nine = made(Boundary::no_flux, Stencil::nine_point);
    std::vector<int> sixths;
    for (const double weight : nine.weights) sixths.push_back(static_cast<int>(std::lround(6 * weight)));
    CHECK(sixths == std::vector<int>{4, 4, 1, 4, 4, 1, 4, 1, 4, 1, 4, 4, 1, 4, 1, 4, 1, 4, 4, 1, 4, 4});
    CHECK(nine.directions.size() == nine.indices.size());
    CHECK(nine.directions.front().right == 1);
    CHECK(nine.directions.front().up == 0);
    CHECK(made(Boundary::wrap, Stencil::sims).weights.front() == 0.05);
    CHECK(made(Boundary::wrap, Stencil::five_point).count(3) == 4);
}
