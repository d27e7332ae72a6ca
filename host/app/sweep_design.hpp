// Which tiles `pelage sweep` runs, from what its options say.
#pragma once

#include "app/sweeper.hpp"
#include "core/experiment.hpp"
#include "sweep/design.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pelage::app {

struct SweepDesign {
    std::vector<sweep::Axis> axes;  // of a grid
    std::vector<sweep::Point> points;
    std::vector<std::string> names;  // of the parameters that vary
};

// Samples of the parameters that some statement of `plain` takes for whole numbers are whole. Throws Error naming the
// option.
SweepDesign sweep_design(const SweepOptions&, const Experiment& plain);

// For messages, where the value of a parameter comes from: "--vary F", "--points FILE: F".
std::string blamed(const SweepOptions&, const std::string& name);

// Throws Error for a value outside the range of its parameter, so that no late tile stumbles over it.
void check_ranges(const SweepOptions&, const SweepDesign&, const Experiment&);

// Of --until steady TOLERANCE. Throws Error where it is written otherwise.
std::optional<double> steady_tolerance(const SweepOptions&);

}  // namespace pelage::app
