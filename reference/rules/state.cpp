// Between the snapshot's doubles and the precision of the run.
#include "reference/rules/state.hpp"

#include "core/subnormal.hpp"

namespace pelage::reference {

namespace {

template <class To, class From>
std::vector<To> cast(const std::vector<From>& values) {
    std::vector<To> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) result[i] = in_precision<To>(values[i]);
    return result;
}

template <class To, class From>
std::vector<std::vector<To>> cast_all(const std::vector<std::vector<From>>& arrays) {
    std::vector<std::vector<To>> result;
    result.reserve(arrays.size());
    for (const auto& values : arrays) result.push_back(cast<To>(values));
    return result;
}

// Every member of either form; the two differ in the type of their numbers alone.
template <class Number, class To, class From>
To convert(const From& from) {
    To to;
    to.columns = from.columns;
    to.rows = from.rows;
    to.layers = from.layers;
    to.origin_x = from.origin_x;
    to.origin_y = from.origin_y;
    to.conc = cast_all<Number>(from.conc);
    to.diff = cast_all<Number>(from.diff);
    to.mappings = cast_all<Number>(from.mappings);
    to.x = cast<Number>(from.x);
    to.y = cast<Number>(from.y);
    to.polarity_x = cast<Number>(from.polarity_x);
    to.polarity_y = cast<Number>(from.polarity_y);
    to.birth = from.birth;
    to.neighbours = from.neighbours;
    to.fixed = from.fixed;
    to.mirrors = from.mirrors;
    return to;
}

}  // namespace

template <class T>
State<T> state_from(const Snapshot& snapshot) {
    return convert<T, State<T>>(snapshot);
}

template <class T>
Snapshot snapshot_from(const State<T>& state) {
    return convert<double, Snapshot>(state);
}

template State<float> state_from(const Snapshot&);
template State<double> state_from(const Snapshot&);
template Snapshot snapshot_from(const State<float>&);
template Snapshot snapshot_from(const State<double>&);

}  // namespace pelage::reference
