// A diagram with two logarithmic axes, drawn by cairo.
#pragma once

#include <cairo.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pelage::bench {

struct Colour {
    double r = 0, g = 0, b = 0;
};

struct Axis {
    std::string title;
    double low = 1, high = 10;  // both above 0
};

enum class Dash { none, dashed, dotted };

struct Spot {
    double x = 0, y = 0;
};

class Diagram {
public:
    Diagram(std::string title, Axis x, Axis y);

    void line(const std::vector<Spot>&, Colour, Dash = Dash::none);
    void dots(const std::vector<Spot>&, Colour);
    void label(Spot, const std::string& text);  // to the right of a place; labels make room for each other
    void legend(const std::string& text, Colour, Dash = Dash::none);  // one line more, to the right of the diagram

    void write(const std::filesystem::path&);  // throws Error naming the file and the reason

private:
    double across(double x) const;  // pixels
    double down(double y) const;
    void frame(const std::string& title);
    void ticks(const Axis&, bool horizontal);
    void use_dash(Dash);
    void draw_labels();
    void text(double x, double y, const std::string&, double size, double lean, bool upward = false);

    struct Free {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };

    Axis x_, y_;
    std::unique_ptr<cairo_surface_t, Free> surface_;
    std::unique_ptr<cairo_t, Free> cairo_;
    double legend_at_;
    std::vector<std::pair<Spot, std::string>> labels_;
};

}  // namespace pelage::bench
