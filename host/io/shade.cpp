// See shade.hpp.
#include "io/shade.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace pelage {

namespace {

constexpr std::size_t samples = 2;    // along each side of a pixel
constexpr double margin = 0.04;       // of the picture, on each side
constexpr double in_the_dark = 0.35;  // light that comes from everywhere

Point unit_of(const Point& p) {
    const double l = length(p);
    return l > 0.0 ? (1.0 / l) * p : p;
}

struct Viewer {  // right, up and towards the viewer
    Point right, up, towards;

    explicit Viewer(const Point& from) : towards(unit_of(from)) {
        const bool steep = std::abs(towards[2]) > 1 - 1e-9;
        right = steep ? Point{1, 0, 0} : unit_of(cross({0, 0, 1}, towards));
        up = cross(towards, right);
    }
    Point operator()(const Point& p) const { return {dot(p, right), dot(p, up), dot(p, towards)}; }
};

struct Drop {      // a vertex on its way into the picture
    Point place;   // column and line in samples, from the upper left; depth: more is nearer
    double light;  // 0 to 1
};

// How bright the vertices are, from the sum of the normals of the triangles around each.
std::vector<double> lights(const Mesh& mesh, const Viewer& view) {
    std::vector<Point> normals(mesh.vertices.size(), Point{});
    for (const Triangle& t : mesh.triangles) {
        const Point normal = mesh.normal(t);
        for (const std::uint32_t corner : t) normals[corner] = normals[corner] + normal;
    }
    const Point sun = unit_of({-0.4, 0.5, 1.0});
    std::vector<double> result;
    result.reserve(normals.size());
    for (const Point& normal : normals) {
        Point n = unit_of(view(normal));
        if (n[2] < 0.0) n = -1.0 * n;
        result.push_back(in_the_dark + (1 - in_the_dark) * std::max(0.0, dot(n, sun)));
    }
    return result;
}

std::vector<Drop> project(const Mesh& mesh, const Viewer& view, std::size_t side) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Point> places;
    places.reserve(mesh.vertices.size());
    Point low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    for (const Point& vertex : mesh.vertices) {
        places.push_back(view(vertex));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], places.back()[axis]);
            high[axis] = std::max(high[axis], places.back()[axis]);
        }
    }
    const double widest = std::max({high[0] - low[0], high[1] - low[1], std::numeric_limits<double>::min()});
    const auto pixels = static_cast<double>(side);
    const double scale = pixels * (1 - 2 * margin) / widest;
    const std::vector<double> light = lights(mesh, view);
    std::vector<Drop> drops;
    drops.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double x = pixels / 2 + scale * (places[i][0] - (low[0] + high[0]) / 2);
        const double y = pixels / 2 - scale * (places[i][1] - (low[1] + high[1]) / 2);
        drops.push_back({{x, y, places[i][2]}, light[i]});
    }
    return drops;
}

// Samples with the depth of what is nearest.
class Raster {
public:
    explicit Raster(std::size_t side)
        : side_(side),
          depth_(side * side, -std::numeric_limits<double>::infinity()),
          colour_(side * side, {255, 255, 255}) {}

    void draw(const std::array<const Drop*, 3>& drops, const std::array<const Rgb*, 3>& colours) {
        const Point &a = drops[0]->place, &b = drops[1]->place, &c = drops[2]->place;
        const double twice = edge(a, b, c[0], c[1]);
        if (!(std::abs(twice) > 0.0)) return;
        const auto [left, right] = span(a[0], b[0], c[0]);
        const auto [top, bottom] = span(a[1], b[1], c[1]);
        for (std::size_t line = top; line < bottom; ++line) {
            for (std::size_t column = left; column < right; ++column) {
                const double x = static_cast<double>(column) + 0.5, y = static_cast<double>(line) + 0.5;
                const Point share{edge(b, c, x, y) / twice, edge(c, a, x, y) / twice, edge(a, b, x, y) / twice};
                if (share[0] < 0 || share[1] < 0 || share[2] < 0) continue;
                const double depth = dot(share, {a[2], b[2], c[2]});
                const std::size_t at = line * side_ + column;
                if (!(depth > depth_[at])) continue;
                depth_[at] = depth;
                colour_[at] = mixed(share, drops, colours);
            }
        }
    }

    Picture picture() const {
        const std::size_t size = side_ / samples;
        Picture result(size, size);
        for (std::size_t line = 0; line < size; ++line) {
            for (std::size_t column = 0; column < size; ++column) result.at(column, line) = mean(column, line);
        }
        return result;
    }

private:
    static double edge(const Point& a, const Point& b, double x, double y) {
        return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    }

    // The samples whose middles may lie between the lowest and the highest of three numbers.
    std::pair<std::size_t, std::size_t> span(double a, double b, double c) const {
        const auto inside = [&](double v) {
            return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(side_)));
        };
        return {inside(std::floor(std::min({a, b, c}))), inside(std::ceil(std::max({a, b, c})))};
    }

    static Rgb mixed(const Point& share, const std::array<const Drop*, 3>& drops,
                     const std::array<const Rgb*, 3>& colours) {
        const double light = dot(share, {drops[0]->light, drops[1]->light, drops[2]->light});
        Rgb result{};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto of = [&](std::size_t k) { return static_cast<double>((*colours[k])[channel]); };
            result[channel] =
                static_cast<std::uint8_t>(std::clamp(light * dot(share, {of(0), of(1), of(2)}) + 0.5, 0.0, 255.0));
        }
        return result;
    }

    Rgb mean(std::size_t column, std::size_t line) const {
        Rgb result{};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            std::size_t sum = samples * samples / 2;
            for (std::size_t y = 0; y < samples; ++y) {
                for (std::size_t x = 0; x < samples; ++x)
                    sum += colour_[(line * samples + y) * side_ + column * samples + x][channel];
            }
            result[channel] = static_cast<std::uint8_t>(sum / (samples * samples));
        }
        return result;
    }

    std::size_t side_;
    std::vector<double> depth_;
    std::vector<Rgb> colour_;
};

}  // namespace

Picture shade(const Mesh& mesh, std::span<const Rgb> colours, const Point& from, std::size_t size) {
    const double far = length(from);
    if (!(far > 0.0) || !std::isfinite(far))
        throw Error(
            fmt::format("a view from ({}, {}, {}); a direction has a length above 0", from[0], from[1], from[2]));
    if (size == 0 || size > largest_view)
        throw Error(fmt::format("a view of {} pixels a side; allowed are 1 to {}", size, largest_view));
    if (colours.size() != mesh.vertices.size())
        throw Error(
            fmt::format("{} colours for {} vertices; one a vertex is needed", colours.size(), mesh.vertices.size()));
    const std::vector<Drop> drops = project(mesh, Viewer(from), size * samples);
    Raster raster(size * samples);
    for (const auto& [a, b, c] : mesh.triangles)
        raster.draw({&drops[a], &drops[b], &drops[c]}, {&colours[a], &colours[b], &colours[c]});
    return raster.picture();
}

}  // namespace pelage
