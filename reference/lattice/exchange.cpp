// See exchange.hpp. Cells of a lattice lie 2 apart: the vector between them is (±2 or 0, ±2 or 0).
#include "reference/lattice/exchange.hpp"

#include <array>
#include <cmath>

namespace pelage::reference {

namespace {

template <class T>
struct Vector {
    T x;
    T y;
    T length() const { return std::sqrt(x * x + y * y); }
};

template <class T>
Vector<T> vector_to(const Neighbour& neighbour) {
    return {static_cast<T>(2 * neighbour.right), static_cast<T>(2 * neighbour.up)};
}

template <class T>
T weight(Stencil stencil, const Neighbour& neighbour) {
    const bool diagonal = neighbour.right != 0 && neighbour.up != 0;
    switch (stencil) {
        case Stencil::nine_point:
            return diagonal ? T(1.0 / 6) : T(4.0 / 6);
        case Stencil::sims:
            return diagonal ? T(0.05) : T(0.2);
        default:
            return T(1);
    }
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
T directed(T rate, T px, T py, const Neighbour& neighbour) {
    if (px == T(0) && py == T(0)) return rate;
    const Vector<T> d = vector_to<T>(neighbour);
    const T along = std::fabs(d.x * px + d.y * py);
    if (neighbour.right == 0 || neighbour.up == 0) return rate * (along * T(0.5));
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
        static constexpr Neighbour axes[] = {{0, 1, 0, false}, {0, 0, 1, false}, {0, 1, 1, false}, {0, 1, -1, false}};
        for (const Neighbour& axis : axes) {
            std::vector<T>& rates = along_[axis_of(axis)];
            rates.resize(plain_.size());
            for (std::size_t cell = 0; cell < rates.size(); ++cell) {
                rates[cell] = directed(plain_[cell], state.polarity_x[cell], state.polarity_y[cell], axis);
            }
        }
    }

    const std::vector<T>& towards(const Neighbour& neighbour) const {
        const std::vector<T>& rates = along_[axis_of(neighbour)];
        return rates.empty() ? plain_ : rates;
    }

private:
    static std::size_t axis_of(const Neighbour& n) {
        return n.up == 0 ? 0 : n.right == 0 ? 1 : n.right == n.up ? 2 : 3;
    }

    const std::vector<T>& plain_;
    std::array<std::vector<T>, 4> along_;
};

// The published program's order: neighbour after neighbour, each rounded on its own.
template <class T>
void add_published(std::vector<T>& next, const std::vector<T>& old, std::size_t cell, std::size_t other, T rate, T dt) {
    next[cell] = next[cell] + ((rate * (old[other] - old[cell])) * dt);
}

// A row between its first and last cell, neighbour after neighbour for all cells at once.
template <class T>
void diffuse_inside(const Medium& medium, std::size_t row, T rate, T dt, const std::vector<T>& old,
                    std::vector<T>& next) {
    const std::size_t columns = medium.shape.columns;
    const std::size_t rows = medium.shape.rows;
    T* sums = next.data() + row * columns;
    const T* own = old.data() + row * columns;
    for (const int up : row_order(medium.shape, medium.arithmetic, row)) {
        if (up > 0 && row + 1 == rows && medium.shape.boundary != Boundary::wrap) continue;  // a grid of one row
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
void diffuse_published(const Medium& medium, T rate, T dt, const std::vector<T>& old, std::vector<T>& next) {
    const std::size_t columns = medium.shape.columns;
    const auto edge_cell = [&](std::size_t cell) {
        for (std::size_t i = medium.surroundings.first[cell]; i < medium.surroundings.first[cell + 1]; ++i) {
            add_published(next, old, cell, medium.surroundings.list[i].cell, rate, dt);
        }
    };
    for (std::size_t row = 0; row < medium.shape.rows; ++row) {
        diffuse_inside(medium, row, rate, dt, old, next);
        edge_cell(row * columns);
        if (columns > 1) edge_cell(row * columns + columns - 1);
    }
}

}  // namespace

template <class T>
void diffuse_uniform(const Medium& medium, std::size_t chemical, T dt, const State<T>& old, State<T>& next) {
    const T rate = old.diff[chemical][0];
    if (medium.arithmetic == Arithmetic::published) {
        diffuse_published(medium, rate, dt, old.conc[chemical], next.conc[chemical]);
        return;
    }
    std::vector<T> sums;
    laplacian(medium.shape, old.conc[chemical], sums);
    const T share = (rate * dt) / laplacian_divisor<T>(medium.shape.stencil);
    std::vector<T>& values = next.conc[chemical];
    for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell] = std::fma(share, sums[cell], values[cell]);
}

template <class T>
void diffuse_per_cell(const Medium& medium, std::size_t chemical, bool anisotropic, T dt, const State<T>& old,
                      State<T>& next) {
    const std::vector<T>& conc = old.conc[chemical];
    const Rates<T> rates(old, chemical, anisotropic);
    std::vector<T>& values = next.conc[chemical];
    for (std::size_t cell = 0; cell < conc.size(); ++cell) {
        for (std::size_t i = medium.surroundings.first[cell]; i < medium.surroundings.first[cell + 1]; ++i) {
            const Neighbour& neighbour = medium.surroundings.list[i];
            const std::vector<T>& along = rates.towards(neighbour);
            const T own_rate = along[cell];
            const T rate = neighbour.outside ? own_rate : shared_rate(own_rate, along[neighbour.cell]);
            if (medium.arithmetic == Arithmetic::published) {
                add_published(values, conc, cell, neighbour.cell, rate, dt);
            } else {
                const T theirs = neighbour.outside ? T(0) : conc[neighbour.cell];
                const T share = (rate * dt) * weight<T>(medium.shape.stencil, neighbour);
                values[cell] = std::fma(share, theirs - conc[cell], values[cell]);
            }
        }
    }
}

template <class T>
void follow_gradients(const Medium& medium, const std::vector<std::int32_t>& requests, const State<T>& old,
                      State<T>& next) {
    for (std::size_t cell = 0; cell < requests.size(); ++cell) {
        if (requests[cell] < 0) continue;
        const std::vector<T>& conc = old.conc[static_cast<std::size_t>(requests[cell])];
        Vector<T> gradient{T(0), T(0)};
        for (std::size_t i = medium.surroundings.first[cell]; i < medium.surroundings.first[cell + 1]; ++i) {
            const Neighbour& neighbour = medium.surroundings.list[i];
            if (neighbour.outside) continue;
            const Vector<T> d = vector_to<T>(neighbour);
            const T difference = conc[neighbour.cell] - conc[cell];
            gradient.x = gradient.x + (difference * d.x) / d.length();
            gradient.y = gradient.y + (difference * d.y) / d.length();
        }
        const T length = gradient.length();
        if (!(length > T(0.0001))) continue;
        next.polarity_x[cell] = gradient.x / length;
        next.polarity_y[cell] = gradient.y / length;
    }
}

#define PELAGE_INSTANTIATE(T)                                                                        \
    template void diffuse_uniform(const Medium&, std::size_t, T, const State<T>&, State<T>&);        \
    template void diffuse_per_cell(const Medium&, std::size_t, bool, T, const State<T>&, State<T>&); \
    template void follow_gradients(const Medium&, const std::vector<std::int32_t>&, const State<T>&, State<T>&);
PELAGE_INSTANTIATE(float)
PELAGE_INSTANTIATE(double)
#undef PELAGE_INSTANTIATE

}  // namespace pelage::reference
