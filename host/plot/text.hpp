// Text on a cairo canvas.
#pragma once

#include <cairo.h>

#include <string>

namespace pelage::plot {

double width_of_text(cairo_t*, const std::string& words, double size);

// `lean`: 0 begins at x, 0.5 is centred there, 1 ends there. y is the middle of small letters.
void draw_text(cairo_t*, double x, double y, const std::string& words, double size, double lean, bool upward = false);

}  // namespace pelage::plot
