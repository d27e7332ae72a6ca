// See exchange.hpp. Cells of a lattice lie 2 apart: the vector between them is (±2 or 0, ±2 or 0).
#include "reference/lattice/exchange.hpp"

#include "core/subnormal.hpp"
#include "reference/lattice/stencil.hpp"
#include "reference/neighbours/gather.hpp"
#include "reference/volume/stencil.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

namespace pelage::reference {

namespace {

template <class T>
struct Vector {
    T x;
    T y;
    T length() const { return std::sqrt(x * x + y * y); }
};

template <class T>
Vector<T> vector_to(Direction to) {
    return {static_cast<T>(2 * to.right), static_cast<T>(2 * to.up)};
}

// 1 / sqrt(8) as a sum of two numbers.
template <class T>
struct DiagonalInverse;
template <>
struct DiagonalInverse<float> {
    static constexpr float high = 0x1.6a09e6p-2f;
    static constexpr float low = 0x1.9fcef4p-27f;
};
template <>
struct DiagonalInverse<double> {
    static constexpr double high = 0x1.6a09e667f3bccp-2;
    static constexpr double low = 0.0;
};

// rate * |d . p| / |d|. The published program takes the quotient and the product in double and rounds once to float;
// two floats in place of each double, and no division, give the same bits on any device with fma.
template <class T>
T directed(T rate, T px, T py, Direction to) {
    if (px == T(0) && py == T(0)) return rate;
    const Vector<T> d = vector_to<T>(to);
    const T along = std::fabs(d.x * px + d.y * py);
    if (to.right == 0 || to.up == 0) return rate * (along * T(0.5));
    const T product = rate * along;
    const T product_error = std::fma(rate, along, -product);
    const T quotient = product * DiagonalInverse<T>::high;
    const T quotient_error = std::fma(product, DiagonalInverse<T>::high, -quotient);
    return quotient + ((quotient_error + product_error * DiagonalInverse<T>::high) + product * DiagonalInverse<T>::low);
}

// Every cell's rate along each of the four axes of the lattice; d and -d share one.
template <class T>
class Rates {
public:
    Rates(const State<T>& state, std::size_t chemical, bool anisotropic) : plain_(state.diff[chemical]) {
        if (!anisotropic) return;
        static constexpr Direction axes[] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
        for (const Direction axis : axes) {
            std::vector<T>& rates = along_[axis_of(axis)];
            rates.resize(plain_.size());
            for (std::size_t cell = 0; cell < rates.size(); ++cell) {
                rates[cell] = directed(plain_[cell], state.polarity_x[cell], state.polarity_y[cell], axis);
            }
        }
    }

    const std::vector<T>& towards(Direction to) const {
        const std::vector<T>& rates = along_[axis_of(to)];
        return rates.empty() ? plain_ : rates;
    }

private:
    static std::size_t axis_of(Direction n) { return n.up == 0 ? 0 : n.right == 0 ? 1 : n.right == n.up ? 2 : 3; }

    const std::vector<T>& plain_;
    std::array<std::vector<T>, 4> along_;
};

// A row between its first and last cell, neighbour after neighbour for all cells at once.
template <class T>
void diffuse_inside(const Medium& medium, std::size_t row, T rate, T dt, const std::vector<T>& old,
                    std::vector<T>& next) {
    const std::size_t columns = medium.lattice.columns;
    const std::size_t rows = medium.lattice.rows;
    T* sums = next.data() + row * columns;
    const T* own = old.data() + row * columns;
    for (const int up : row_order(medium.lattice, row)) {
        if (up > 0 && row + 1 == rows && medium.lattice.boundary != Boundary::wrap) continue;  // a grid of one row
        const std::size_t there = up == 0 ? row : up < 0 ? (row + rows - 1) % rows : (row + 1) % rows;
        const T* theirs = old.data() + there * columns;
        for (std::size_t side = 0; side < 3; ++side) {  // left, middle, right
            if (up == 0 && side == 1) continue;
            for (std::size_t column = 1; column + 1 < columns; ++column) {
                sums[column] = sums[column] + ((rate * (theirs[column + side - 1] - own[column])) * dt);
            }
        }
    }
}

template <class T>
void diffuse_published(const Medium& medium, const std::vector<T>& rates, T dt, const std::vector<T>& old,
                       std::vector<T>& next) {
    const T rate = rates[0];
    const auto same = [&](std::size_t) -> const std::vector<T>& { return rates; };
    const std::size_t columns = medium.lattice.columns;
    const auto edge_cell = [&](std::size_t cell) {
        gather_cell(medium.adjacency, Arithmetic::published, cell, same, dt, old, next);
    };
    for (std::size_t row = 0; row < medium.lattice.rows; ++row) {
        diffuse_inside(medium, row, rate, dt, old, next);
        edge_cell(row * columns);
        if (columns > 1) edge_cell(row * columns + columns - 1);
    }
}

}  // namespace

template <class T>
void diffuse_uniform(const Medium& medium, std::size_t chemical, T dt, const State<T>& old, State<T>& next) {
    const T rate = old.diff[chemical][0];
    if (medium.lattice.arithmetic == Arithmetic::published) {
        diffuse_published(medium, old.diff[chemical], dt, old.conc[chemical], next.conc[chemical]);
        return;
    }
    std::vector<T> sums;
    T divisor;
    if (medium.volume) {
        laplacian(*medium.volume, old.conc[chemical], sums);
        divisor = laplacian_divisor<T>(medium.volume->stencil);
    } else {
        laplacian(medium.lattice, old.conc[chemical], sums);
        divisor = laplacian_divisor<T>(medium.lattice.stencil);
    }
    const T share = (rate * dt) / divisor;
    std::vector<T>& values = next.conc[chemical];
    for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell] = std::fma(share, sums[cell], values[cell]);
}

template <class T>
void diffuse_per_cell(const Medium& medium, std::size_t chemical, bool anisotropic, T dt, const State<T>& old,
                      State<T>& next) {
    const Rates<T> rates(old, chemical, anisotropic);
    const auto towards = [&](std::size_t entry) -> const std::vector<T>& {
        return rates.towards(medium.adjacency.directions[entry]);
    };
    for (std::size_t cell = 0; cell < medium.adjacency.cells(); ++cell) {
        gather_cell(medium.adjacency, medium.lattice.arithmetic, cell, towards, dt, old.conc[chemical],
                    next.conc[chemical]);
    }
}

template <class T>
void follow_gradients(const Medium& medium, const std::vector<std::int32_t>& requests, const State<T>& old,
                      State<T>& next) {
    const LatticeAdjacency& adjacency = medium.adjacency;
    for (std::size_t cell = 0; cell < requests.size(); ++cell) {
        if (requests[cell] < 0) continue;
        const std::vector<T>& conc = old.conc[static_cast<std::size_t>(requests[cell])];
        Vector<T> gradient{T(0), T(0)};
        for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry) {
            const std::uint32_t there = adjacency.indices[entry];
            if (there == Adjacency::nobody || !is_beside(adjacency.directions[entry])) continue;
            const Vector<T> d = vector_to<T>(adjacency.directions[entry]);
            const T difference = conc[there] - conc[cell];
            gradient.x = gradient.x + (difference * d.x) / d.length();
            gradient.y = gradient.y + (difference * d.y) / d.length();
        }
        const T length = gradient.length();
        if (!(length > T(0.0001))) continue;
        next.polarity_x[cell] = gradient.x / length;
        next.polarity_y[cell] = gradient.y / length;
    }
}

namespace {

// sums[cell] = add(sum, entry, theirs less own) for each neighbour in turn.
template <class T, class Add>
std::vector<T> summed(const LatticeAdjacency& adjacency, const std::vector<T>& values, Add add) {
    std::vector<T> sums(values.size(), T(0));
    for (std::size_t cell = 0; cell < sums.size(); ++cell) {
        for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry) {
            const std::uint32_t there = adjacency.indices[entry];
            const T theirs = there == Adjacency::nobody ? T(0) : values[there];
            sums[cell] = add(sums[cell], entry, theirs - values[cell]);
        }
    }
    return sums;
}

}  // namespace

template <class T>
std::vector<T> laplacian_of(const Medium& medium, const std::vector<T>& values) {
    return summed(medium.adjacency, values, [&](T sum, std::size_t entry, T difference) {
        return std::fma(static_cast<T>(medium.adjacency.weights[entry]), difference, sum);
    });
}

template <class T>
std::vector<T> gradient_of(const Medium& medium, Axis axis, const std::vector<T>& values) {
    return summed(medium.adjacency, values, [&](T sum, std::size_t entry, T difference) {
        const Direction to = medium.adjacency.directions[entry];
        const std::array steps{to.right, to.up, to.deep};
        const int along = steps[static_cast<std::size_t>(axis)];
        const int off = std::abs(to.right) + std::abs(to.up) + std::abs(to.deep) - std::abs(along);
        if (!is_beside(to) || along == 0 || off != 0) return sum;
        return along < 0 ? sum - difference * T(0.5) : sum + difference * T(0.5);
    });
}

template <class T>
std::vector<T> stencil_of(const Medium& medium, const NamedStencil& stencil, const std::vector<T>& values) {
    const Lattice& lattice = medium.lattice;
    const int reach = stencil.reach();
    std::vector<T> sums(values.size(), T(0));
    for (int up = -reach; up <= reach; ++up) {
        for (int right = -reach; right <= reach; ++right) {
            if (stencil.weight(right, up) == 0.0) continue;
            const T weight = in_precision<T>(stencil.weight(right, up));
            for (std::size_t cell = 0; cell < sums.size(); ++cell) {
                const auto row = place_repeated(cell / lattice.columns, up, lattice.rows, lattice.boundary);
                const auto column = place_repeated(cell % lattice.columns, right, lattice.columns, lattice.boundary);
                const T value = row && column ? values[*row * lattice.columns + *column] : T(0);
                sums[cell] = std::fma(weight, value, sums[cell]);
            }
        }
    }
    return sums;
}

#define PELAGE_INSTANTIATE(T)                                                                        \
    template std::vector<T> laplacian_of(const Medium&, const std::vector<T>&);                      \
    template std::vector<T> gradient_of(const Medium&, Axis, const std::vector<T>&);                 \
    template std::vector<T> stencil_of(const Medium&, const NamedStencil&, const std::vector<T>&);   \
    template void diffuse_uniform(const Medium&, std::size_t, T, const State<T>&, State<T>&);        \
    template void diffuse_per_cell(const Medium&, std::size_t, bool, T, const State<T>&, State<T>&); \
    template void follow_gradients(const Medium&, const std::vector<std::int32_t>&, const State<T>&, State<T>&);
PELAGE_INSTANTIATE(float)
PELAGE_INSTANTIATE(double)
#undef PELAGE_INSTANTIATE

}  // namespace pelage::reference
