// See arrangements.hpp: which elements of a circle are cells.
#include "core/arrangements.hpp"

namespace pelage {

namespace {

// The first i from `low` on for which `holds`, which stays true once it is; `high` when there is none.
template <class Holds>
std::int64_t first(std::int64_t low, std::int64_t high, Holds holds) {
    while (low < high) {
        const std::int64_t middle = low + (high - low) / 2;
        if (holds(middle))
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

}  // namespace

Circle::Circle(const CreateGrid& grid)
    : hex_(grid.arrangement == Arrangement::hex_circle),
      n_(static_cast<std::int64_t>(grid.columns)),
      x_(grid.x),
      y_(grid.y) {}

// Those of a row are one stretch, left and right of the centre.
std::size_t Circle::count() const {
    std::int64_t cells = 0;
    for (std::int64_t row = begin(); row < n_; ++row) {
        const std::int64_t middle = first(begin(), n_, [&](std::int64_t i) { return element(row, i).right; });
        cells += first(middle, n_, [&](std::int64_t i) { return !element(row, i).inside; });
        cells -= first(begin(), middle, [&](std::int64_t i) { return element(row, i).inside; });
    }
    return static_cast<std::size_t>(cells);
}

Circle::Element Circle::square(std::int64_t row, std::int64_t column) const {
    const double half = static_cast<double>(n_) / 2.0;
    const double dy = static_cast<double>(row) - half + 0.5;
    const double dx = static_cast<double>(column) - half + 0.5;
    return {dx >= 0.0, dy * dy + dx * dx <= half * half};
}

Circle::Element Circle::hex(std::int64_t row, std::int64_t column) const {
    const auto [x, y] = place<float>(row, column);
    const float dx = x - static_cast<float>(x_);
    const float dy = y - static_cast<float>(y_);
    return {dx >= 0.0f, dx * dx + dy * dy <= static_cast<float>(n_ * n_)};
}

}  // namespace pelage
