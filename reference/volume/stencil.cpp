// See stencil.hpp.
#include "reference/volume/stencil.hpp"

#include "core/adjacency.hpp"

#include <cmath>
#include <cstddef>

namespace pelage::reference {

namespace {

// The cells around one of them, as the boundary has them.
template <class T>
class Neighbourhood {
public:
    Neighbourhood(const Volume& volume, const std::vector<T>& field, std::size_t column, std::size_t row,
                  std::size_t layer)
        : volume_(volume), field_(field), column_(column), row_(row), layer_(layer) {}

    T at(int right, int up, int deep) const {
        const auto column = place_repeated(column_, right, volume_.columns, volume_.boundary);
        const auto row = place_repeated(row_, up, volume_.rows, volume_.boundary);
        const auto layer = place_repeated(layer_, deep, volume_.layers, volume_.boundary);
        if (!column || !row || !layer) return T(0);
        return field_[(*layer * volume_.rows + *row) * volume_.columns + *column];
    }
    T sides(int up, int deep) const { return at(-1, up, deep) + at(1, up, deep); }

private:
    const Volume& volume_;
    const std::vector<T>& field_;
    std::size_t column_, row_, layer_;
};

// Where neighbours before and behind have the cell's own value this is five_point, to the bit.
template <class T>
T seven_cells(const Neighbourhood<T>& near) {
    const T own = near.at(0, 0, 0);
    const T plane = (near.at(0, -1, 0) + near.at(0, 1, 0)) + near.sides(0, 0);
    return std::fma(T(-4), own, plane) + std::fma(T(-2), own, near.at(0, 0, -1) + near.at(0, 0, 1));
}

// 3 and 1 of a row off both middles, 14 and 3 of a row off one.
template <class T>
T outer_row(const Neighbourhood<T>& near, int up, int deep) {
    return std::fma(T(3), near.at(0, up, deep), near.sides(up, deep));
}
template <class T>
T inner_row(const Neighbourhood<T>& near, int up, int deep) {
    return std::fma(T(14), near.at(0, up, deep), T(3) * near.sides(up, deep));
}
template <class T>
T outer_layer(const Neighbourhood<T>& near, int deep) {
    return (outer_row(near, -1, deep) + outer_row(near, 1, deep)) + inner_row(near, 0, deep);
}

template <class T>
T twenty_seven_cells(const Neighbourhood<T>& near) {
    const T layer = std::fma(T(14), near.sides(0, 0), inner_row(near, -1, 0) + inner_row(near, 1, 0));
    const T all = (outer_layer(near, -1) + outer_layer(near, 1)) + layer;
    return std::fma(T(-128), near.at(0, 0, 0), all);
}

}  // namespace

template <class T>
void laplacian(const Volume& volume, const std::vector<T>& field, std::vector<T>& sums) {
    sums.resize(field.size());
    for (std::size_t cell = 0; cell < field.size(); ++cell) {
        const std::size_t line = cell / volume.columns;
        const Neighbourhood<T> near(volume, field, cell % volume.columns, line % volume.rows, line / volume.rows);
        sums[cell] = volume.stencil == Stencil::seven_point ? seven_cells(near) : twenty_seven_cells(near);
    }
}

template void laplacian(const Volume&, const std::vector<float>&, std::vector<float>&);
template void laplacian(const Volume&, const std::vector<double>&, std::vector<double>&);

}  // namespace pelage::reference
