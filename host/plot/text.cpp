// See text.hpp.
#include "plot/text.hpp"

#include <numbers>

namespace pelage::plot {

double width_of_text(cairo_t* cairo, const std::string& words, double size) {
    cairo_set_font_size(cairo, size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, words.c_str(), &extents);
    return extents.x_advance;
}

void draw_text(cairo_t* cairo, double x, double y, const std::string& words, double size, double lean, bool upward) {
    const double width = width_of_text(cairo, words, size);
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    if (upward) cairo_rotate(cairo, -std::numbers::pi / 2);
    cairo_move_to(cairo, -lean * width, 0.36 * size);
    cairo_show_text(cairo, words.c_str());
    cairo_restore(cairo);
}

}  // namespace pelage::plot
