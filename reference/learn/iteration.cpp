// See iteration.hpp.
#include "reference/learn/iteration.hpp"

#include "core/neural.hpp"
#include "reference/common/with_fma.hpp"
#include "reference/functions/quick_sigmoid.hpp"
#include "reference/learn/sums.hpp"

#include <algorithm>
#include <cmath>

namespace pelage::reference {

namespace {

// [1 2 1; 2 4 2; 1 2 1] is [1 2 1] times itself; less 16 in the middle it is 16 times the Laplacian. `share` is c / 16.
// Seen from either side two cells are to each other what they were, so that it leads forth and back alike.
template <class T>
PELAGE_INLINE void diffuse_plane(std::size_t side, T share, const T* x, T* y) {
    std::vector<T> sums(side * side);
    for (std::size_t row = 0; row < side; ++row) {
        const T* own = x + row * side;
        for (std::size_t column = 0; column < side; ++column) {
            const T left = own[column == 0 ? side - 1 : column - 1];
            const T right = own[column + 1 == side ? 0 : column + 1];
            sums[row * side + column] = std::fma(T(2), own[column], left + right);
        }
    }
    for (std::size_t row = 0; row < side; ++row) {
        const T* below = sums.data() + (row == 0 ? side - 1 : row - 1) * side;
        const T* above = sums.data() + (row + 1 == side ? 0 : row + 1) * side;
        for (std::size_t column = 0; column < side; ++column) {
            const std::size_t cell = row * side + column;
            const T around = std::fma(T(2), sums[cell], below[column] + above[column]);
            y[cell] = std::fma(share, std::fma(T(-16), x[cell], around), x[cell]);
        }
    }
}

template <class T>
PELAGE_INLINE void diffuse(const LearningShape& shape, const T* x, T* y) {
    for (std::size_t i = 0; i < shape.chemicals; ++i) {
        const T share = static_cast<T>(group_rate(i, shape.chemicals) / 16);
        diffuse_plane(shape.side, share, x + i * shape.cells(), y + i * shape.cells());
    }
}

template <class T>
PELAGE_INLINE void add_scaled(std::size_t count, T factor, const T* row, T* sums) {
    for (std::size_t n = 0; n < count; ++n) sums[n] = std::fma(factor, row[n], sums[n]);
}

// A matrix [rows][columns] as [columns][rows].
template <class T>
PELAGE_INLINE std::vector<T> turned(const T* matrix, std::size_t rows, std::size_t columns) {
    std::vector<T> result(rows * columns);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column)
            result[column * rows + row] = matrix[row * columns + column];
    }
    return result;
}

template <class T>
struct Cell {  // what one cell's numbers become on their way
    explicit Cell(const LearningShape& shape)
        : x(shape.chemicals), y(shape.chemicals), z(shape.hidden), act(shape.hidden), slope(shape.hidden) {}
    std::vector<T> x, y, z, act, slope;
};

template <class T>
PELAGE_INLINE void take(const LearningShape& shape, const T* planes, std::size_t cell, std::vector<T>& to) {
    for (std::size_t i = 0; i < shape.chemicals; ++i) to[i] = planes[i * shape.cells() + cell];
}
template <class T>
PELAGE_INLINE void put(const LearningShape& shape, const std::vector<T>& from, std::size_t cell, T* planes) {
    for (std::size_t i = 0; i < shape.chemicals; ++i) planes[i * shape.cells() + cell] = from[i];
}

// z = x W0 + b0, act = z s with s = sigmoid(5 z), and its slope s + 5 z s (1 - s).
template <class T>
PELAGE_INLINE void ask_hidden(const LearningShape& shape, const T* weights, Cell<T>& cell) {
    std::copy_n(weights + shape.bias(), shape.hidden, cell.z.begin());
    for (std::size_t i = 0; i < shape.chemicals; ++i)
        add_scaled(shape.hidden, cell.x[i], weights + i * shape.hidden, cell.z.data());
    for (std::size_t h = 0; h < shape.hidden; ++h) {
        const T z = cell.z[h];
        const T s = functions::quick_sigmoid(T(5) * z);
        cell.act[h] = z * s;
        cell.slope[h] = std::fma(T(5) * cell.act[h], T(1) - s, s);
    }
}

template <class T>
PELAGE_INLINE void iterate_here(const LearningShape& shape, const T* weights, const T* x, T* y) {
    diffuse(shape, x, y);
    Cell<T> cell(shape);
    for (std::size_t at = 0; at < shape.cells(); ++at) {
        take(shape, x, at, cell.x);
        take(shape, y, at, cell.y);
        ask_hidden(shape, weights, cell);
        for (std::size_t h = 0; h < shape.hidden; ++h)
            add_scaled(shape.chemicals, cell.act[h], weights + shape.second() + h * shape.chemicals, cell.y.data());
        put(shape, cell.y, at, y);
    }
}

// The outer products x dz and act dy, and dz itself, added to the sums of a lane.
template <class T>
PELAGE_INLINE void add_products(const LearningShape& shape, const Cell<T>& cell, const std::vector<T>& dz, T* sums) {
    for (std::size_t i = 0; i < shape.chemicals; ++i)
        add_scaled(shape.hidden, cell.x[i], dz.data(), sums + i * shape.hidden);
    for (std::size_t h = 0; h < shape.hidden; ++h) sums[shape.bias() + h] = sums[shape.bias() + h] + dz[h];
    for (std::size_t h = 0; h < shape.hidden; ++h)
        add_scaled(shape.chemicals, cell.act[h], cell.y.data(), sums + shape.second() + h * shape.chemicals);
}

template <class T>
PELAGE_INLINE void reverse_here(const LearningShape& shape, const T* weights, const T* x, T* after, std::size_t sample,
                                WeightSums<T>& sums) {
    const std::vector<T> first = turned(weights, shape.chemicals, shape.hidden);
    const std::vector<T> second = turned(weights + shape.second(), shape.hidden, shape.chemicals);
    std::vector<T> before(shape.sample());
    diffuse(shape, after, before.data());
    Cell<T> cell(shape);
    std::vector<T> dz(shape.hidden), dx(shape.chemicals);
    for (std::size_t at = 0; at < shape.cells(); ++at) {
        take(shape, x, at, cell.x);
        take(shape, after, at, cell.y);
        take(shape, before.data(), at, dx);
        ask_hidden(shape, weights, cell);
        std::fill(dz.begin(), dz.end(), T(0));
        for (std::size_t i = 0; i < shape.chemicals; ++i)
            add_scaled(shape.hidden, cell.y[i], second.data() + i * shape.hidden, dz.data());
        for (std::size_t h = 0; h < shape.hidden; ++h) dz[h] = dz[h] * cell.slope[h];
        for (std::size_t h = 0; h < shape.hidden; ++h)
            add_scaled(shape.chemicals, dz[h], first.data() + h * shape.chemicals, dx.data());
        add_products(shape, cell, dz, sums.of(sample, at));
        put(shape, dx, at, before.data());
    }
    std::copy(before.begin(), before.end(), after);
}

#ifdef PELAGE_WITH_FMA
template <class T>
PELAGE_WITH_FMA void iterate_with_fma(const LearningShape& shape, const T* weights, const T* x, T* y) {
    iterate_here(shape, weights, x, y);
}
template <class T>
PELAGE_WITH_FMA void reverse_with_fma(const LearningShape& shape, const T* weights, const T* x, T* after,
                                      std::size_t sample, WeightSums<T>& sums) {
    reverse_here(shape, weights, x, after, sample, sums);
}
#endif

}  // namespace

template <class T>
void iterate(const LearningShape& shape, const std::vector<T>& weights, const T* x, T* y) {
#ifdef PELAGE_WITH_FMA
    if (runs_with_fma()) return iterate_with_fma(shape, weights.data(), x, y);
#endif
    iterate_here(shape, weights.data(), x, y);
}

template <class T>
void reverse_iteration(const LearningShape& shape, const std::vector<T>& weights, const T* x, T* after,
                       std::size_t sample, WeightSums<T>& sums) {
#ifdef PELAGE_WITH_FMA
    if (runs_with_fma()) return reverse_with_fma(shape, weights.data(), x, after, sample, sums);
#endif
    reverse_here(shape, weights.data(), x, after, sample, sums);
}

template <class T>
std::vector<T> WeightSums<T>::totals() const {
    std::vector<T> totals(shape_.weights());
    std::vector<T> lanes(sum_lanes);
    for (std::size_t weight = 0; weight < shape_.weights(); ++weight) {
        std::fill(lanes.begin(), lanes.end(), T(0));
        for (std::size_t run = 0; run < shape_.batch * cell_runs; ++run) {
            for (std::size_t lane = 0; lane < sum_lanes; ++lane)
                lanes[lane] = lanes[lane] + lanes_[(run * sum_lanes + lane) * shape_.weights() + weight];
        }
        totals[weight] = folded(lanes.data(), sum_lanes);
    }
    return totals;
}

template void iterate(const LearningShape&, const std::vector<float>&, const float*, float*);
template void iterate(const LearningShape&, const std::vector<double>&, const double*, double*);
template class WeightSums<float>;
template class WeightSums<double>;
template void reverse_iteration(const LearningShape&, const std::vector<float>&, const float*, float*, std::size_t,
                                WeightSums<float>&);
template void reverse_iteration(const LearningShape&, const std::vector<double>&, const double*, double*, std::size_t,
                                WeightSums<double>&);

}  // namespace pelage::reference
