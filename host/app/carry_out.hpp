// A run that is prepared, to its end: batch after batch, what is due in between, and what is left when it ends early.
#pragma once

#include "app/film_plan.hpp"
#include "app/machine.hpp"
#include "app/prepare.hpp"
#include "app/run_options.hpp"
#include "core/tissue.hpp"

#include <optional>

namespace pelage::app {

// Returns the exit code. What goes wrong with the device or with results is an Error that names the latest state that
// is safe, and the command that goes on from it.
int carry_out(const RunOptions&, const Prepared&, const Machine&, const std::optional<FilmPlan>&, Tissue&);

}  // namespace pelage::app
