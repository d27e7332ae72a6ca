// See shape.hpp.
#include "io/shape.hpp"

#include "core/columns.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"

#include <fmt/format.h>
#include <string>

namespace pelage {

void check_shape(const Snapshot& snapshot, const Experiment& experiment) {
    const auto check = [&](std::size_t length, const std::string& what) {
        if (length == snapshot.cells()) return;
        throw Error(
            fmt::format("the snapshot has {}, but {} for {} of them", counted(snapshot.cells(), "cell"), what, length));
    };
    const auto chemicals = experiment.chemicals.size();
    if (snapshot.conc.size() != chemicals || snapshot.diff.size() != chemicals) {
        throw Error(fmt::format("the snapshot has {} and rates of {}; the experiment defines {}",
                                counted(snapshot.conc.size(), "chemical"), snapshot.diff.size(), chemicals));
    }
    if (snapshot.lattice()) check(snapshot.columns * snapshot.rows, "its lattice has places");
    if (snapshot.volume()) check(snapshot.columns * snapshot.rows * snapshot.layers, "its volume has places");
    each_cell_column([&](const char* name, const auto& column) { check(column.size(), name); }, snapshot);
}

}  // namespace pelage
