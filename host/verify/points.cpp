// See points.hpp.
#include "verify/points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pelage::verify {

namespace {

double as_float(double value) { return static_cast<double>(static_cast<float>(value)); }

class Draw {
public:
    explicit Draw(std::uint32_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
    }
    std::size_t below(std::size_t end) { return static_cast<std::size_t>(between(0, static_cast<double>(end))); }

private:
    std::mt19937 engine_;
};

double side_of(std::size_t count) { return std::sqrt(3.4641016 * static_cast<double>(count)); }

}  // namespace

Points hexagonal(std::size_t count) {
    Points points;
    const auto columns = std::max<std::size_t>(1, static_cast<std::size_t>(side_of(count) / 2));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t row = i / columns;
        points.add(as_float(2.0 * static_cast<double>(i % columns) + static_cast<double>(row % 2) - side_of(count) / 2),
                   as_float(1.7321 * static_cast<double>(row) - side_of(count) / 2));
    }
    return points;
}

Points jittered(std::size_t count, std::uint32_t seed) {
    Draw draw(seed);
    Points points = hexagonal(count);
    for (double& x : points.x) x = as_float(x + draw.between(-0.4, 0.4));
    for (double& y : points.y) y = as_float(y + draw.between(-0.4, 0.4));
    return points;
}

Points crowd(std::size_t count, double side, std::uint32_t seed) {
    Draw draw(seed);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = as_float(draw.between(-side / 2, side / 2));
        points.add(x, as_float(draw.between(-side / 2, side / 2)));
    }
    return points;
}

Points uniform(std::size_t count, std::uint32_t seed) { return crowd(count, side_of(count), seed); }

Points clustered(std::size_t count, std::uint32_t seed) {
    Draw draw(seed);
    const Points centres = crowd(count / 200 + 1, 20 * side_of(count), seed + 1);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t centre = draw.below(centres.size());
        const double x = as_float(centres.x[centre] + draw.between(-10, 10));
        points.add(x, as_float(centres.y[centre] + draw.between(-10, 10)));
    }
    return points;
}

Points line(std::size_t count) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) points.add(1.5 * static_cast<double>(i), 7.0);
    return points;
}

Points pairs_apart(std::size_t count, double dx, double dy) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const auto pair = static_cast<double>(i / 2), second = static_cast<double>(i % 2);
        points.add(dx * pair + second, dy * pair + second);
    }
    return points;
}

Points square_at_radius(std::size_t side) {
    Points points;
    for (std::size_t i = 0; i < side * side; ++i) {
        const std::size_t row = i / side;
        points.add(3.0 * static_cast<double>(i % side), 3.0 * static_cast<double>(row));
    }
    return points;
}

Points moved(Points points, double dx, double dy) {
    for (double& x : points.x) x = as_float(x + dx);
    for (double& y : points.y) y = as_float(y + dy);
    return points;
}

Points shuffled(Points points, std::uint32_t seed) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    Points result;
    for (const std::size_t i : order) result.add(points.x[i], points.y[i]);
    return result;
}

}  // namespace pelage::verify
