// Warnings: an experiment that can be run, but hardly means what it says.
#pragma once

#include "core/experiment.hpp"
#include "language/outline.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage {

struct Warning {
    std::string lint;  // which one warns: "idle-rule", "unstable" ...
    std::size_t line = 0;
    std::size_t column = 0;  // in characters, both from 1
    std::string text;
};

// In order of their places. `last` is the iteration at which the run will end.
std::vector<Warning> lint(const Experiment&, const Outline&, std::uint64_t last);

// "SOURCE:LINE:COLUMN: warning: TEXT [LINT]"
std::string shown(const Experiment&, const Warning&);

}  // namespace pelage
