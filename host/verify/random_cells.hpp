// The statements `use`, `create` and `set` of a random experiment.
#pragma once

#include "verify/random_draft.hpp"

namespace pelage::verify {

void draw_seed(Draft&);
void draw_uses(Draft&);     // of every chemical, and of polarity
void create_cells(Draft&);  // free ones, in one or several stretches with their own `use`
void set_cells(Draft&);

}  // namespace pelage::verify
