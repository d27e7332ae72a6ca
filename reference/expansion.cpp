// See expansion.hpp.
#include "reference/expansion.hpp"

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

// Cells lie 2 apart around the lattice's centre, rounded to float as the published program holds them.
template <class T>
T place(double origin, std::size_t index, std::size_t count) {
    const double offset = static_cast<double>(index) - static_cast<double>(count) / 2.0;
    return static_cast<T>(static_cast<float>(origin + offset * 2 + 1));
}

}  // namespace

template <class T>
void expand_state(State<T>& state, const Insertion& insertion) {
    const Growth growth{state.columns, state.rows, insertion};
    growth.apply_all(state.conc);
    growth.apply_all(state.diff);
    growth.apply_all(state.mappings);
    growth.apply(state.polarity_x);
    growth.apply(state.polarity_y);
    growth.apply(state.birth);
    growth.apply(state.neighbours);
    growth.apply(state.fixed);
    state.columns = growth.new_columns();
    state.rows = growth.new_rows();
    state.x.resize(state.columns * state.rows);
    state.y.resize(state.columns * state.rows);
    for (std::size_t cell = 0; cell < state.x.size(); ++cell) {
        state.x[cell] = place<T>(state.origin_x, cell % state.columns, state.columns);
        state.y[cell] = place<T>(state.origin_y, cell / state.columns, state.rows);
    }
}

template void expand_state(State<float>&, const Insertion&);
template void expand_state(State<double>&, const Insertion&);

}  // namespace pelage::reference
