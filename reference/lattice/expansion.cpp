// See expansion.hpp.
#include "reference/lattice/expansion.hpp"

#include "core/subnormal.hpp"

#include <cstdint>

namespace pelage::reference {

namespace {

struct Growth {
    std::size_t columns;  // before
    std::size_t rows;
    const Insertion& insertion;

    std::size_t new_columns() const { return columns + (insertion.column ? 1 : 0); }
    std::size_t new_rows() const { return rows + (insertion.column ? 0 : 1); }

    // The old cell that a new cell copies.
    std::size_t source(std::size_t column, std::size_t row) const {
        const std::size_t pick = insertion.picks[insertion.column ? row : column];
        const std::size_t old_column = insertion.column && column > pick ? column - 1 : column;
        const std::size_t old_row = !insertion.column && row > pick ? row - 1 : row;
        return old_row * columns + old_column;
    }

    bool newborn(std::size_t column, std::size_t row) const {
        return insertion.column ? column == insertion.picks[row] + 1 : row == insertion.picks[column] + 1;
    }

    void mark_newborn(std::vector<std::uint32_t>& birth, std::uint64_t iteration) const {
        for (std::size_t cell = 0; cell < birth.size(); ++cell) {
            if (newborn(cell % new_columns(), cell / new_columns()))
                birth[cell] = static_cast<std::uint32_t>(iteration);
        }
    }

    template <class V>
    void apply(std::vector<V>& field) const {
        std::vector<V> grown(new_columns() * new_rows());
        for (std::size_t row = 0; row < new_rows(); ++row) {
            for (std::size_t column = 0; column < new_columns(); ++column) {
                grown[row * new_columns() + column] = field[source(column, row)];
            }
        }
        field.swap(grown);
    }

    template <class T>
    void apply_all(std::vector<std::vector<T>>& fields) const {
        for (auto& field : fields) apply(field);
    }
};

// Cells lie 2 apart around the lattice's centre.
template <class T>
T place(double origin, std::size_t index, std::size_t count) {
    const double offset = static_cast<double>(index) - static_cast<double>(count) / 2.0;
    return in_precision<T>(origin + offset * 2 + 1);
}

}  // namespace

template <class T>
void lay_out(State<T>& state, std::size_t columns, std::size_t rows) {
    state.columns = columns;
    state.rows = rows;
    state.x.resize(columns * rows);
    state.y.resize(columns * rows);
    for (std::size_t cell = 0; cell < state.x.size(); ++cell) {
        state.x[cell] = place<T>(state.origin_x, cell % columns, columns);
        state.y[cell] = place<T>(state.origin_y, cell / columns, rows);
    }
}

template <class T>
void expand_state(State<T>& state, const Insertion& insertion, std::uint64_t iteration) {
    const Growth growth{state.columns, state.rows, insertion};
    growth.apply_all(state.conc);
    growth.apply_all(state.diff);
    growth.apply_all(state.mappings);
    growth.apply(state.polarity_x);
    growth.apply(state.polarity_y);
    growth.apply(state.birth);
    growth.apply(state.neighbours);
    growth.apply(state.fixed);
    growth.mark_newborn(state.birth, iteration);
    lay_out(state, growth.new_columns(), growth.new_rows());
}

template void lay_out(State<float>&, std::size_t, std::size_t);
template void lay_out(State<double>&, std::size_t, std::size_t);
template void expand_state(State<float>&, const Insertion&, std::uint64_t);
template void expand_state(State<double>&, const Insertion&, std::uint64_t);

}  // namespace pelage::reference
