// Approximate neighbour search by odd-even transposition in a matrix; the method is told at core's SpatialSorting.
#pragma once

#include "core/neighbours.hpp"

#include <span>
#include <vector>

namespace pelage::reference {

template <class T>
class SortedMatrix {
public:
    explicit SortedMatrix(SpatialSorting);  // throws Error for a window that is not offered

    // Takes new positions (cells are only ever added, with ids above all others) and sorts.
    void update(std::span<const T> x, std::span<const T> y);
    void begin(std::span<const std::uint32_t> order);  // the next update goes on from it; empty: from that of ids

    Neighbours neighbours() const;        // of the latest update, by cell id
    SearchStatistics statistics() const;  // of neighbours() against the exact sets

    std::size_t side() const { return side_; }
    std::vector<std::uint32_t> order() const;  // cell ids, row after row

private:
    struct Place {
        T x, y;
        std::uint32_t id;
    };

    bool sort_rows();
    bool sort_columns();
    void find(std::size_t place, std::vector<std::uint32_t>& found) const;

    std::size_t reach_;  // rows and columns on either side
    std::size_t rounds_;
    std::size_t cells_ = 0;
    std::size_t side_ = 0;
    std::vector<Place> places_;  // side * side
};

extern template class SortedMatrix<float>;
extern template class SortedMatrix<double>;

}  // namespace pelage::reference
