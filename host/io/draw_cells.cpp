// See draw_cells.hpp.
#include "io/draw_cells.hpp"

#include "core/error.hpp"
#include "io/colour.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace pelage {
namespace {

constexpr double voronoi_half_side = 1.5;
constexpr double mark_length = 0.9;
constexpr double mark_half_width = 0.12;
constexpr double longest_side = 4096.0;
constexpr Rgb white{255, 255, 255};
constexpr Rgb black{0, 0, 0};

// From tissue units to pixels: x to the right, y up, centres of pixels at halves.
struct View {
    double left = 0.0;
    double top = 0.0;
    double scale = 1.0;  // pixels a unit
    std::size_t columns = 1;
    std::size_t rows = 1;

    double x(std::size_t column) const { return left + (static_cast<double>(column) + 0.5) / scale; }
    double y(std::size_t line) const { return top - (static_cast<double>(line) + 0.5) / scale; }
};

View fit(const Snapshot& cells, const CellDrawing& drawing) {
    const double margin = margin_of(drawing.shape);
    const auto [low, high] = drawing.box ? *drawing.box : box_around(cells);
    const double width = high[0] - low[0] + 2 * margin;
    const double height = high[1] - low[1] + 2 * margin;
    const double size = static_cast<double>(std::max<std::size_t>(1, drawing.size));
    const double longer = std::max(width, height);
    const double scale = std::max(size / longer, std::min(2.0, longest_side / longer));
    const auto pixels = [&](double length) {
        return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length * scale - 1e-6)));
    };
    return {low[0] - margin, high[1] + margin, scale, pixels(width), pixels(height)};
}

// Calls visit(column, line, dx, dy) for all pixels whose centres lie within `reach` of (x, y) in both directions.
template <class Visit>
void around(const View& view, double x, double y, double reach, const Visit& visit) {
    const auto clamp = [](double value, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(count)));
    };
    const auto first_column = clamp(std::floor((x - reach - view.left) * view.scale), view.columns);
    const auto last_column = clamp(std::ceil((x + reach - view.left) * view.scale), view.columns);
    const auto first_line = clamp(std::floor((view.top - y - reach) * view.scale), view.rows);
    const auto last_line = clamp(std::ceil((view.top - y + reach) * view.scale), view.rows);
    for (std::size_t line = first_line; line < last_line; ++line) {
        for (std::size_t column = first_column; column < last_column; ++column) {
            visit(column, line, view.x(column) - x, view.y(line) - y);
        }
    }
}

// `outside` is the signed distance to the shape's edge in units: its share of the pixel is blended in.
void blend(Rgb& pixel, const Rgb& colour, double outside, double scale) {
    const double share = std::clamp(0.5 - outside * scale, 0.0, 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
        pixel[k] = static_cast<std::uint8_t>(std::lround(pixel[k] + share * (colour[k] - pixel[k])));
    }
}

double outside_circle(double dx, double dy) { return std::sqrt(dx * dx + dy * dy) - 1.0; }

double outside_hexagon(double dx, double dy) {
    dx = std::abs(dx);
    dy = std::abs(dy);
    return std::max(dx, 0.5 * dx + 0.8660254037844386 * dy) - 1.0;
}

double outside_mark(double dx, double dy, double px, double py) {
    const double along = std::clamp(dx * px + dy * py, 0.0, mark_length);
    return std::hypot(dx - along * px, dy - along * py) - mark_half_width;
}

void draw_shapes(const Snapshot& cells, const Brush& brush, CellShape shape, const View& view, Picture& picture) {
    const auto outside = shape == CellShape::circle ? outside_circle : outside_hexagon;
    for (std::size_t i = 0; i < cells.cells(); ++i) {
        if (!std::isfinite(cells.x[i]) || !std::isfinite(cells.y[i])) continue;
        const auto colour = brush(i);
        around(view, cells.x[i], cells.y[i], 1.2 + 1.0 / view.scale, [&](auto column, auto line, double dx, double dy) {
            blend(picture.at(column, line), colour, outside(dx, dy), view.scale);
        });
    }
}

void draw_voronoi(const Snapshot& cells, const Brush& brush, const View& view, Picture& picture) {
    std::vector<double> nearest(view.columns * view.rows, std::numeric_limits<double>::max());
    for (std::size_t i = 0; i < cells.cells(); ++i) {
        if (!std::isfinite(cells.x[i]) || !std::isfinite(cells.y[i])) continue;
        const auto colour = brush(i);
        around(view, cells.x[i], cells.y[i], voronoi_half_side, [&](auto column, auto line, double dx, double dy) {
            double& least = nearest[line * view.columns + column];
            const double distance = dx * dx + dy * dy;
            if (distance >= least || std::max(std::abs(dx), std::abs(dy)) > voronoi_half_side) return;
            least = distance;
            picture.at(column, line) = colour;
        });
    }
}

void draw_marks(const Snapshot& cells, const View& view, Picture& picture) {
    for (std::size_t i = 0; i < cells.cells(); ++i) {
        const double length = std::hypot(cells.polarity_x[i], cells.polarity_y[i]);
        if (!std::isfinite(cells.x[i]) || !std::isfinite(cells.y[i]) || !(length > 0.0) || std::isinf(length)) continue;
        const double px = cells.polarity_x[i] / length;
        const double py = cells.polarity_y[i] / length;
        around(view, cells.x[i], cells.y[i], 1.2, [&](auto column, auto line, double dx, double dy) {
            blend(picture.at(column, line), black, outside_mark(dx, dy, px, py), view.scale);
        });
    }
}

}  // namespace

double margin_of(CellShape shape) { return shape == CellShape::circle ? 1.0 : shape == CellShape::hexagon ? 1.2 : 1.5; }

CellBox box_around(const Snapshot& cells) {
    CellBox box;
    box.low.fill(std::numeric_limits<double>::max());
    box.high.fill(-box.low[0]);
    for (std::size_t i = 0; i < cells.cells(); ++i) {
        const std::array<double, 2> at{cells.x[i], cells.y[i]};
        if (!std::isfinite(at[0]) || !std::isfinite(at[1])) continue;
        for (std::size_t k = 0; k < 2; ++k) {
            box.low[k] = std::min(box.low[k], at[k]);
            box.high[k] = std::max(box.high[k], at[k]);
        }
    }
    return box.low[0] > box.high[0] ? CellBox{} : box;
}

Picture draw_cells(const Snapshot& cells, const Brush& brush, const CellDrawing& drawing) {
    const auto view = fit(cells, drawing);
    Picture picture(view.columns, view.rows, white);
    if (drawing.shape == CellShape::voronoi) {
        draw_voronoi(cells, brush, view, picture);
    } else {
        draw_shapes(cells, brush, drawing.shape, view, picture);
    }
    if (drawing.polarity_marks) draw_marks(cells, view, picture);
    return picture;
}

Picture draw_cells(const Snapshot& cells, const Output& output, const CellDrawing& drawing) {
    if (output.chemical >= cells.conc.size()) throw Error("the output's chemical is not among the snapshot's");
    const std::span<const double> values = cells.conc[output.chemical];
    return draw_cells(cells, Brush(output, {values}, output.range ? ValueRange{} : range_of(values)), drawing);
}

}  // namespace pelage
