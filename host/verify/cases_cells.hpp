// One table of experiments with free cells, for tests, verification and benchmarks.
#pragma once

#include <string>
#include <vector>

namespace pelage::verify {

// An irregular tissue with three chemicals; names no file.
extern const std::string cell_tissue;

struct CellCase {
    std::string name;
    std::string lines;     // what the case adds to cell_tissue
    std::string before{};  // and what before it: chemicals of its own

    std::string text() const { return before + cell_tissue + lines; }
    bool divides() const { return lines.find(" divide") != std::string::npos; }
};

// "cells/...": one feature each, and one case for each model of the table of reactions.
const std::vector<CellCase>& cell_cases();

}  // namespace pelage::verify
