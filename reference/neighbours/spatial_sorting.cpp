// See spatial_sorting.hpp.
#include "reference/neighbours/spatial_sorting.hpp"

#include "core/error.hpp"
#include "reference/neighbours/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace pelage::reference {

namespace {

std::size_t reach_of(std::size_t window) {
    for (std::size_t reach = 1; reach <= 5; ++reach) {
        if (window == (2 * reach + 1) * (2 * reach + 1) - 1) return reach;
    }
    throw Error(fmt::format("a spatial sorting window of {} places; allowed are 8, 24, 48, 80, 120", window));
}

std::size_t side_for(std::size_t cells) {
    std::size_t side = 0;
    while (side * side < cells) ++side;
    return side;
}

}  // namespace

template <class T>
SortedMatrix<T>::SortedMatrix(SpatialSorting settings) : reach_(reach_of(settings.window)), rounds_(settings.rounds) {}

template <class T>
void SortedMatrix<T>::begin(std::span<const std::uint32_t> order) {
    places_.clear();
    for (const std::uint32_t id : order) places_.push_back({T(0), T(0), id});
    cells_ = order.size();
}

template <class T>
void SortedMatrix<T>::update(std::span<const T> x, std::span<const T> y) {
    if (places_.empty() || x.size() < cells_) {
        cells_ = 0;
        places_.clear();
    }
    constexpr T beyond = std::numeric_limits<T>::max();
    places_.resize(cells_);
    for (; cells_ < x.size(); ++cells_) places_.push_back({beyond, beyond, static_cast<std::uint32_t>(cells_)});
    for (Place& place : places_) {
        place.x = x[place.id];
        place.y = y[place.id];
    }
    side_ = side_for(cells_);
    places_.resize(side_ * side_, {beyond, beyond, std::numeric_limits<std::uint32_t>::max()});
    // Every swap raises the sum of column * x + row * y over all places, so this ends.
    for (std::size_t round = 0; rounds_ == 0 || round < rounds_; ++round) {
        const bool rows_moved = sort_rows();
        const bool columns_moved = sort_columns();
        if (!rows_moved && !columns_moved) break;
    }
}

template <class T>
bool SortedMatrix<T>::sort_rows() {
    bool moved = false;
    for (std::size_t row = 0; row < side_; ++row) {
        Place* line = places_.data() + row * side_;
        for (const std::size_t start : {1u, 0u}) {
            for (std::size_t column = start; column + 1 < side_; column += 2) {
                if (!(line[column].x > line[column + 1].x)) continue;
                std::swap(line[column], line[column + 1]);
                moved = true;
            }
        }
    }
    return moved;
}

template <class T>
bool SortedMatrix<T>::sort_columns() {
    bool moved = false;
    for (const std::size_t start : {1u, 0u}) {
        for (std::size_t row = start; row + 1 < side_; row += 2) {
            Place* lower = places_.data() + row * side_;
            Place* upper = lower + side_;
            for (std::size_t column = 0; column < side_; ++column) {
                if (!(lower[column].y > upper[column].y)) continue;
                std::swap(lower[column], upper[column]);
                moved = true;
            }
        }
    }
    return moved;
}

template <class T>
void SortedMatrix<T>::find(std::size_t place, std::vector<std::uint32_t>& found) const {
    const std::size_t row = place / side_;
    const std::size_t column = place % side_;
    const std::size_t top = std::min(row + reach_, side_ - 1);
    const std::size_t right = std::min(column + reach_, side_ - 1);
    const Place& centre = places_[place];
    constexpr T square = static_cast<T>(interaction_range * interaction_range);
    for (std::size_t r = row - std::min(row, reach_); r <= top; ++r) {
        for (std::size_t c = column - std::min(column, reach_); c <= right; ++c) {
            const std::size_t other = r * side_ + c;
            if (other == place || other >= cells_) continue;  // the larger coordinates stay behind the cells
            const T dx = places_[other].x - centre.x;
            const T dy = places_[other].y - centre.y;
            if (dx * dx + dy * dy <= square) found.push_back(places_[other].id);
        }
    }
}

template <class T>
Neighbours SortedMatrix<T>::neighbours() const {
    const std::vector<std::uint32_t> ids = order();
    std::vector<std::size_t> place_of(cells_);
    for (std::size_t place = 0; place < cells_; ++place) place_of[ids[place]] = place;
    Neighbours all;
    all.first.reserve(cells_ + 1);
    all.first.push_back(0);
    all.ids.reserve(8 * cells_);
    for (std::size_t cell = 0; cell < cells_; ++cell) {
        find(place_of[cell], all.ids);
        std::sort(all.ids.begin() + static_cast<std::ptrdiff_t>(all.first.back()), all.ids.end());
        all.first.push_back(all.ids.size());
    }
    return all;
}

template <class T>
std::vector<std::uint32_t> SortedMatrix<T>::order() const {
    std::vector<std::uint32_t> ids(cells_);
    for (std::size_t place = 0; place < cells_; ++place) ids[place] = places_[place].id;
    return ids;
}

template <class T>
SearchStatistics SortedMatrix<T>::statistics() const {
    std::vector<T> x(cells_), y(cells_);
    for (std::size_t place = 0; place < cells_; ++place) {
        x[places_[place].id] = places_[place].x;
        y[places_[place].id] = places_[place].y;
    }
    const Neighbours exact = neighbours_exact<T>(x, y, static_cast<T>(interaction_range));
    const Neighbours found = neighbours();
    SearchStatistics statistics;
    statistics.iterations = 1;
    statistics.cells = cells_;
    statistics.neighbours_exact = exact.ids.size();
    for (std::size_t cell = 0; cell < cells_; ++cell) {
        std::vector<std::uint32_t> missed;
        std::ranges::set_difference(exact.of(cell), found.of(cell), std::back_inserter(missed));
        statistics.neighbours_missed += missed.size();
        statistics.cells_with_misses += missed.empty() ? 0 : 1;
        statistics.most_missed = std::max<std::uint64_t>(statistics.most_missed, missed.size());
    }
    return statistics;
}

template class SortedMatrix<float>;
template class SortedMatrix<double>;

}  // namespace pelage::reference
