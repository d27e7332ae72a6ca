// See stencil.hpp. [1 4 1; 4 -20 4; 1 4 1] is the product of [1 4 1] with itself, less 36 in the middle.
#include "reference/lattice/stencil.hpp"

#include <cmath>

namespace pelage::reference {

namespace {

// One row with an element more at either end, as the boundary has it.
template <class T>
class PaddedRow {
public:
    PaddedRow(const Lattice& lattice, const std::vector<T>& field, std::ptrdiff_t row)
        : values_(lattice.columns + 2, T(0)) {
        const auto rows = static_cast<std::ptrdiff_t>(lattice.rows);
        if (row < 0 || row >= rows) {
            if (lattice.boundary == Boundary::absorbing) return;
            const bool below = row < 0;
            row = (lattice.boundary == Boundary::wrap) == below ? rows - 1 : 0;
        }
        const T* from = field.data() + static_cast<std::size_t>(row) * lattice.columns;
        for (std::size_t column = 0; column < lattice.columns; ++column) values_[column + 1] = from[column];
        if (lattice.boundary == Boundary::absorbing) return;
        const bool wrap = lattice.boundary == Boundary::wrap;
        values_.front() = from[wrap ? lattice.columns - 1 : 0];
        values_.back() = from[wrap ? 0 : lattice.columns - 1];
    }

    T left(std::size_t column) const { return values_[column]; }
    T own(std::size_t column) const { return values_[column + 1]; }
    T right(std::size_t column) const { return values_[column + 2]; }

private:
    std::vector<T> values_;
};

template <class T>
std::vector<T> row_sums(const Lattice& lattice, const PaddedRow<T>& row) {
    std::vector<T> sums(lattice.columns);
    for (std::size_t column = 0; column < lattice.columns; ++column) {
        const T sides = row.left(column) + row.right(column);
        sums[column] =
            lattice.stencil == Stencil::moore ? sides + row.own(column) : std::fma(T(4), row.own(column), sides);
    }
    return sums;
}

template <class T>
void nine_cells(const Lattice& lattice, const std::vector<T>& field, std::vector<T>& sums) {
    const auto sums_of = [&](std::ptrdiff_t row) { return row_sums(lattice, PaddedRow<T>(lattice, field, row)); };
    std::vector<T> below = sums_of(-1);
    std::vector<T> own = sums_of(0);
    for (std::size_t row = 0; row < lattice.rows; ++row) {
        const std::vector<T> above = sums_of(static_cast<std::ptrdiff_t>(row) + 1);
        for (std::size_t column = 0; column < lattice.columns; ++column) {
            const std::size_t cell = row * lattice.columns + column;
            const T outer = below[column] + above[column];
            sums[cell] = lattice.stencil == Stencil::moore
                             ? std::fma(T(-9), field[cell], outer + own[column])
                             : std::fma(T(-36), field[cell], std::fma(T(4), own[column], outer));
        }
        below = own;
        own = above;
    }
}

template <class T>
void five_cells(const Lattice& lattice, const std::vector<T>& field, std::vector<T>& sums) {
    for (std::size_t row = 0; row < lattice.rows; ++row) {
        const auto at = static_cast<std::ptrdiff_t>(row);
        const PaddedRow<T> down(lattice, field, at - 1), own(lattice, field, at), up(lattice, field, at + 1);
        for (std::size_t column = 0; column < lattice.columns; ++column) {
            const T sum = (down.own(column) + up.own(column)) + (own.left(column) + own.right(column));
            sums[row * lattice.columns + column] = std::fma(T(-4), own.own(column), sum);
        }
    }
}

}  // namespace

template <class T>
void laplacian(const Lattice& lattice, const std::vector<T>& field, std::vector<T>& sums) {
    sums.resize(field.size());
    if (field.empty()) return;
    if (lattice.stencil == Stencil::five_point) {
        five_cells(lattice, field, sums);
    } else {
        nine_cells(lattice, field, sums);
    }
}

template <class T>
T laplacian_divisor(Stencil stencil) {
    if (stencil == Stencil::twenty_seven_point) return T(30);
    return stencil == Stencil::nine_point ? T(6) : stencil == Stencil::sims ? T(20) : T(1);
}

template void laplacian(const Lattice&, const std::vector<float>&, std::vector<float>&);
template void laplacian(const Lattice&, const std::vector<double>&, std::vector<double>&);
template float laplacian_divisor(Stencil);
template double laplacian_divisor(Stencil);

}  // namespace pelage::reference
