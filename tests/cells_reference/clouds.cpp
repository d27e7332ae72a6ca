// See clouds.hpp.
#include "cells_reference/clouds.hpp"

#include <random>

namespace test {

namespace {

template <class T>
T spread(std::mt19937& random, T half) {  // not std::uniform_real_distribution, whose draws differ between libraries
    return half * (static_cast<T>(random() >> 8) * static_cast<T>(0x1p-23) - T(1));
}

}  // namespace

template <class T>
Cloud<T> hexagonal(std::size_t columns, std::size_t rows, T jitter, std::uint32_t seed) {
    std::mt19937 random(seed);
    Cloud<T> cloud;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const T x = T(2) * static_cast<T>(column) + static_cast<T>(row % 2) - static_cast<T>(columns);
            const T y = static_cast<T>(1.7321) * static_cast<T>(row) - static_cast<T>(rows);
            cloud.add(x + spread(random, jitter), y + spread(random, jitter));
        }
    }
    return cloud;
}

template <class T>
Cloud<T> scattered(std::size_t points, T width, T height, std::uint32_t seed) {
    std::mt19937 random(seed);
    Cloud<T> cloud;
    for (std::size_t i = 0; i < points; ++i) {
        const T x = spread(random, width / 2);
        cloud.add(x, spread(random, height / 2));
    }
    return cloud;
}

template <class T>
Cloud<T> clustered(std::size_t clusters, std::size_t points_each, std::uint32_t seed) {
    const Cloud<T> centres = scattered<T>(clusters, T(400), T(400), seed);
    Cloud<T> cloud;
    for (std::size_t cluster = 0; cluster < clusters; ++cluster) {
        const Cloud<T> near = scattered<T>(points_each, T(6), T(6), seed + 1 + static_cast<std::uint32_t>(cluster));
        for (std::size_t i = 0; i < points_each; ++i) {
            cloud.add(centres.x[cluster] + near.x[i], centres.y[cluster] + near.y[i]);
        }
    }
    return cloud;
}

template <class T>
Cloud<T> moved(Cloud<T> cloud, T dx, T dy) {
    for (T& x : cloud.x) x += dx;
    for (T& y : cloud.y) y += dy;
    return cloud;
}

template <class T>
pelage::Neighbours by_force(std::span<const T> x, std::span<const T> y, T radius, bool inclusive) {
    pelage::Neighbours found;
    found.first.push_back(0);
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; j < x.size(); ++j) {
            const T dx = x[j] - x[i];
            const T dy = y[j] - y[i];
            const T d2 = dx * dx + dy * dy;
            const bool near = inclusive ? d2 <= radius * radius : d2 < radius * radius;
            if (j != i && near) found.ids.push_back(static_cast<std::uint32_t>(j));
        }
        found.first.push_back(found.ids.size());
    }
    return found;
}

template Cloud<float> hexagonal(std::size_t, std::size_t, float, std::uint32_t);
template Cloud<double> hexagonal(std::size_t, std::size_t, double, std::uint32_t);
template Cloud<float> scattered(std::size_t, float, float, std::uint32_t);
template Cloud<double> scattered(std::size_t, double, double, std::uint32_t);
template Cloud<float> clustered(std::size_t, std::size_t, std::uint32_t);
template Cloud<double> clustered(std::size_t, std::size_t, std::uint32_t);
template Cloud<float> moved(Cloud<float>, float, float);
template Cloud<double> moved(Cloud<double>, double, double);
template pelage::Neighbours by_force(std::span<const float>, std::span<const float>, float, bool);
template pelage::Neighbours by_force(std::span<const double>, std::span<const double>, double, bool);

}  // namespace test
