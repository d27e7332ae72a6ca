// From a picture to what a learner compares with.
#pragma once

#include "core/learning.hpp"
#include "learn/picture.hpp"
#include "learn/settings.hpp"

namespace pelage::learn {

// Pixels of the picture that become one cell.
double scale_of(const Settings&, const Colours&);

// Random directions of patches, and what the picture has along them, turned by as many angles as the settings say.
// Throws Error where the picture is too small for that.
LearningTask make_task(const Settings&, const Colours&);

}  // namespace pelage::learn
