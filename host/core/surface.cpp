// See surface.hpp.
#include "core/surface.hpp"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

// What each cell gives away less what it takes, in a unit of time at rate 1.
std::vector<double> given(const Adjacency& adjacency, const std::vector<double>& values) {
    std::vector<double> result(values.size(), 0.0);
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
        for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry)
            result[cell] += adjacency.weights[entry] * (values[cell] - values[adjacency.indices[entry]]);
    }
    return result;
}

double norm(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum);
}

}  // namespace

std::vector<double> coordinates(const MeshSurface& surface, std::size_t axis) {
    std::vector<double> result(surface.cells());
    std::ranges::transform(surface.mesh.vertices, result.begin(), [&](const Point& p) { return p[axis]; });
    return result;
}

double stiffness(const MeshSurface& surface) {
    constexpr int rounds = 40;
    constexpr double slack = 1.03;
    std::vector<double> values(surface.cells());
    std::uint32_t bits = 1;
    for (double& value : values) {
        bits = bits * 1664525u + 1013904223u;  // any start that no symmetry has
        value = static_cast<double>(bits) / 4294967296.0 - 0.5;
    }
    double largest = 0.0;
    for (int round = 0; round < rounds; ++round) {
        const double before = norm(values);
        if (!(before > 0.0)) break;
        for (double& value : values) value /= before;
        values = given(surface.adjacency, values);
        largest = norm(values);
    }
    return slack * largest;
}

}  // namespace pelage
