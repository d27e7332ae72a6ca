// Clouds of points on which a neighbour search may stumble.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage::verify {

struct Points {
    std::vector<double> x, y;

    std::size_t size() const { return x.size(); }
    void add(double px, double py) {
        x.push_back(px);
        y.push_back(py);
    }
};

// All have the density of touching cells where nothing else is said; coordinates are exact in float.
Points hexagonal(std::size_t count);
Points jittered(std::size_t count, std::uint32_t seed);
Points uniform(std::size_t count, std::uint32_t seed);
Points clustered(std::size_t count, std::uint32_t seed);
Points line(std::size_t count);
// Two beside each other, the next two that far from them.
Points pairs_apart(std::size_t count, double dx, double dy);
Points square_at_radius(std::size_t side);                         // neighbours exactly 3 apart along rows and columns
Points crowd(std::size_t count, double side, std::uint32_t seed);  // uniform in a square of that side

Points moved(Points, double dx, double dy);
Points shuffled(Points, std::uint32_t seed);

}  // namespace pelage::verify
