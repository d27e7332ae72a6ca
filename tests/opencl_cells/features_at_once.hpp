// Many features of free cells in one experiment.
#pragma once

#include "support/free_cells.hpp"
#include "verify/cases_cells.hpp"

#include <cstddef>
#include <string>

namespace test {

// One feature in `of`, counted from the one of that number, all in one experiment: the device against the reference.
inline void check_features_at_once(pelage::Precision precision, bool together, std::size_t first, std::size_t of) {
    using namespace pelage;
    std::string before;
    std::string lines = verify::cell_tissue;
    std::size_t number = 0;
    for (const verify::CellCase& feature : verify::cell_cases()) {
        if (feature.lines.rfind("rule", 0) != 0 || number++ % of != first) continue;
        before += feature.before;
        lines += feature.lines;
    }
    const auto what = experiment(before + lines);
    CellsOptions options;
    options.together = together;
    const auto expected = on_reference(what, precision);
    const auto found = on_device(what, options, precision);

    check_equal_runs(*expected, *found, 30, 6);
}

}  // namespace test
