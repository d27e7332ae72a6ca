// See canvas.hpp.
#include "plot/canvas.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "plot/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace pelage::bench {

namespace {

constexpr int width = 1200, height = 760;
constexpr double left = 110, right = 300, top = 60, bottom = 80;  // margins
constexpr Colour ink{0.13, 0.13, 0.15};

void use(cairo_t* cairo, Colour colour) { cairo_set_source_rgb(cairo, colour.r, colour.g, colour.b); }

// 0.01, 1, 1000 as they are, further ones as powers.
std::string power_of_ten(int exponent) {
    if (exponent < -3 || exponent > 4) return fmt::format("1e{}", exponent);
    return fmt::format("{:.{}f}", std::pow(10.0, exponent), exponent < 0 ? -exponent : 0);
}

}  // namespace

Diagram::Diagram(std::string title, Axis x, Axis y)
    : x_(std::move(x)),
      y_(std::move(y)),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      cairo_(cairo_create(surface_.get())),
      legend_at_(top + 12) {
    frame(title);
}

double Diagram::across(double x) const {
    return left + (width - left - right) * std::log(x / x_.low) / std::log(x_.high / x_.low);
}

double Diagram::down(double y) const {
    return height - bottom - (height - top - bottom) * std::log(y / y_.low) / std::log(y_.high / y_.low);
}

void Diagram::text(double x, double y, const std::string& words, double size, double lean, bool upward) {
    plot::draw_text(cairo_.get(), x, y, words, size, lean, upward);
}

void Diagram::frame(const std::string& title) {
    cairo_t* cairo = cairo_.get();
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    ticks(x_, true);
    ticks(y_, false);
    use(cairo, ink);
    cairo_set_line_width(cairo, 1.5);
    cairo_rectangle(cairo, left, top, width - left - right, height - top - bottom);
    cairo_stroke(cairo);
    text(left + (width - left - right) / 2, top / 2, title, 20, 0.5);
    text(left + (width - left - right) / 2, height - 24, x_.title, 16, 0.5);
    text(28, top + (height - top - bottom) / 2, y_.title, 16, 0.5, true);
}

void Diagram::ticks(const Axis& axis, bool horizontal) {
    cairo_t* cairo = cairo_.get();
    for (int exponent = -12; exponent <= 18; ++exponent) {
        for (int digit = 1; digit < 10; ++digit) {
            const double value = digit * std::pow(10.0, exponent);
            if (value < axis.low * 0.9999 || value > axis.high * 1.0001) continue;
            const double place = std::round(horizontal ? across(value) : down(value)) + 0.5;
            const double grey = digit == 1 ? 0.78 : 0.92;
            cairo_set_source_rgb(cairo, grey, grey, grey);
            cairo_set_line_width(cairo, 1);
            cairo_move_to(cairo, horizontal ? place : left, horizontal ? top : place);
            cairo_line_to(cairo, horizontal ? place : width - right, horizontal ? height - bottom : place);
            cairo_stroke(cairo);
            if (digit != 1) continue;
            use(cairo, ink);
            if (horizontal) {
                text(place, height - bottom + 20, power_of_ten(exponent), 15, 0.5);
            } else {
                text(left - 10, place, power_of_ten(exponent), 15, 1);
            }
        }
    }
}

void Diagram::use_dash(Dash dash) {
    constexpr double dashes[] = {8, 5};
    constexpr double points[] = {2, 4};
    cairo_set_dash(cairo_.get(), dash == Dash::dotted ? points : dashes, dash == Dash::none ? 0 : 2, 0);
}

void Diagram::line(const std::vector<Spot>& spots, Colour colour, Dash dash) {
    if (spots.empty()) return;
    cairo_t* cairo = cairo_.get();
    cairo_save(cairo);
    cairo_rectangle(cairo, left, top, width - left - right, height - top - bottom);
    cairo_clip(cairo);
    use(cairo, colour);
    cairo_set_line_width(cairo, 2.5);
    use_dash(dash);
    cairo_new_path(cairo);
    for (const Spot& spot : spots) cairo_line_to(cairo, across(spot.x), down(spot.y));
    cairo_stroke(cairo);
    cairo_restore(cairo);
}

void Diagram::dots(const std::vector<Spot>& spots, Colour colour) {
    use(cairo_.get(), colour);
    for (const Spot& spot : spots) {
        cairo_arc(cairo_.get(), across(spot.x), down(spot.y), 5, 0, 2 * std::numbers::pi);
        cairo_fill(cairo_.get());
    }
}

void Diagram::label(Spot spot, const std::string& words) { labels_.emplace_back(spot, words); }

void Diagram::draw_labels() {
    constexpr double wide = 130, high = 15;
    std::ranges::sort(labels_, [](const auto& a, const auto& b) { return a.first.y > b.first.y; });
    std::vector<Spot> taken;
    use(cairo_.get(), ink);
    for (const auto& [spot, words] : labels_) {
        Spot at{across(spot.x) + 10, down(spot.y)};
        for (const Spot& other : taken) {
            if (std::fabs(other.x - at.x) < wide && std::fabs(other.y - at.y) < high) at.y = other.y + high;
        }
        taken.push_back(at);
        text(at.x, at.y, words, 13, 0);
    }
}

void Diagram::legend(const std::string& words, Colour colour, Dash dash) {
    cairo_t* cairo = cairo_.get();
    use(cairo, colour);
    cairo_set_line_width(cairo, 3);
    use_dash(dash);
    cairo_move_to(cairo, width - right + 18, legend_at_);
    cairo_line_to(cairo, width - right + 54, legend_at_);
    cairo_stroke(cairo);
    use_dash(Dash::none);
    use(cairo, ink);
    text(width - right + 62, legend_at_, words, 14, 0);
    legend_at_ += 24;
}

void Diagram::write(const std::filesystem::path& file) {
    std::string bytes;
    const auto keep = [](void* to, const unsigned char* from, unsigned int count) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(from), count);
        return CAIRO_STATUS_SUCCESS;
    };
    draw_labels();
    cairo_surface_flush(surface_.get());
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), keep, &bytes);
    if (status != CAIRO_STATUS_SUCCESS) {
        throw Error(fmt::format("{} cannot be drawn: {}", file.string(), cairo_status_to_string(status)));
    }
    write_file(file, bytes);
}

}  // namespace pelage::bench
