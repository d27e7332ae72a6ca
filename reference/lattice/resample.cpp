// See resample.hpp.
#include "reference/lattice/resample.hpp"

#include "core/subnormal.hpp"
#include "reference/lattice/expansion.hpp"

#include <cmath>

namespace pelage::reference {

namespace {

// The sample at `place` of one axis, where value(i) is the old element i.
template <class T, class Value>
T sample(const Sampling& axis, std::size_t place, const Value& value) {
    const std::int32_t* source = axis.sources.data() + place * (1 + axis.others);
    const T base = value(source[0]);
    T sum = base;
    for (std::size_t other = 0; other < axis.others; ++other) {
        const T weight = in_precision<T>(axis.weights[place * axis.others + other]);
        sum = std::fma(weight, value(source[1 + other]) - base, sum);
    }
    return sum;
}

template <class T>
std::vector<T> interpolated(const std::vector<T>& old, std::size_t old_columns, const Resampling& to) {
    std::vector<T> result;
    result.reserve(to.across.places * to.up.places);
    for (std::size_t row = 0; row < to.up.places; ++row) {
        for (std::size_t column = 0; column < to.across.places; ++column) {
            const auto of_row = [&](std::int32_t old_row) {
                const T* const values = old.data() + static_cast<std::size_t>(old_row) * old_columns;
                return sample<T>(to.across, column, [&](std::int32_t at) { return values[at]; });
            };
            result.push_back(sample<T>(to.up, row, of_row));
        }
    }
    return result;
}

template <class V>
void take_nearest(std::vector<V>& field, std::size_t old_columns, const Resampling& to) {
    std::vector<V> result;
    result.reserve(to.across.places * to.up.places);
    for (const std::int32_t row : to.up.nearest) {
        const std::size_t start = static_cast<std::size_t>(row) * old_columns;
        for (const std::int32_t column : to.across.nearest)
            result.push_back(field[start + static_cast<std::size_t>(column)]);
    }
    field.swap(result);
}

template <class T>
void clamp(const Bounds& bounds, std::vector<T>& values) {
    const T floor = in_precision<T>(bounds.floor);
    const T limit = in_precision<T>(bounds.limit);
    for (T& value : values) value = value < floor ? floor : value > limit ? limit : value;
}

}  // namespace

template <class T>
void resample_state(State<T>& state, const Resampling& to, const std::vector<Bounds>& bounds) {
    const std::size_t old_columns = state.columns;
    for (std::size_t chemical = 0; chemical < state.conc.size(); ++chemical) {
        state.conc[chemical] = interpolated(state.conc[chemical], old_columns, to);
        clamp(bounds[chemical], state.conc[chemical]);
    }
    for (auto* fields : {&state.diff, &state.mappings}) {
        for (auto& field : *fields) take_nearest(field, old_columns, to);
    }
    take_nearest(state.polarity_x, old_columns, to);
    take_nearest(state.polarity_y, old_columns, to);
    take_nearest(state.birth, old_columns, to);
    take_nearest(state.neighbours, old_columns, to);
    take_nearest(state.fixed, old_columns, to);
    lay_out(state, to.across.places, to.up.places);
}

template void resample_state(State<float>&, const Resampling&, const std::vector<Bounds>&);
template void resample_state(State<double>&, const Resampling&, const std::vector<Bounds>&);

}  // namespace pelage::reference
