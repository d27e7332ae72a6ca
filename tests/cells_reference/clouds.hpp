// Clouds of points on which a neighbour search may stumble, and the search that cannot.
#pragma once

#include "core/neighbours.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace test {

template <class T>
struct Cloud {
    std::vector<T> x, y;

    void add(T px, T py) {
        x.push_back(px);
        y.push_back(py);
    }
    std::size_t size() const { return x.size(); }
};

template <class T>
Cloud<T> hexagonal(std::size_t columns, std::size_t rows, T jitter, std::uint32_t seed);
template <class T>
Cloud<T> scattered(std::size_t points, T width, T height, std::uint32_t seed);  // uniform about the origin
template <class T>
Cloud<T> clustered(std::size_t clusters, std::size_t points_each, std::uint32_t seed);
template <class T>
Cloud<T> moved(Cloud<T>, T dx, T dy);

// By comparing all pairs; `inclusive`: d2 <= radius^2 counts too.
template <class T>
pelage::Neighbours by_force(std::span<const T> x, std::span<const T> y, T radius, bool inclusive = false);

}  // namespace test
