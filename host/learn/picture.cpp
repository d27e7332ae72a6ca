// See picture.hpp.
#include "learn/picture.hpp"

#include "core/error.hpp"
#include "core/learning.hpp"
#include "io/field.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pelage::learn {

namespace {

// A pixel's number along one axis; those beyond the edge repeat it, or the picture.
std::size_t held(double place, std::size_t count, bool wrap) {
    const auto many = static_cast<double>(count);
    const double found = wrap ? place - many * std::floor(place / many) : std::clamp(place, 0.0, many - 1);
    return std::min(static_cast<std::size_t>(found), count - 1);
}

struct Place {
    double x, y;  // in pixels from the picture's lower left corner
};

// Linear between the centres of the four pixels around.
double smooth(const Colours& picture, std::size_t colour, Place place, bool wrap) {
    const double left = std::floor(place.x - 0.5), low = std::floor(place.y - 0.5);
    const double across = place.x - 0.5 - left, up = place.y - 0.5 - low;
    const auto at = [&](double column, double row) {
        return picture
            .values[colour][held(row, picture.rows, wrap) * picture.columns + held(column, picture.columns, wrap)];
    };
    const double below = at(left, low) * (1 - across) + at(left + 1, low) * across;
    const double above = at(left, low + 1) * (1 - across) + at(left + 1, low + 1) * across;
    return below * (1 - up) + above * up;
}

}  // namespace

Colours parse_colours(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with("\x89PNG")) throw Error(fmt::format("'{}' is not a PNG picture", name));
    Colours colours;
    static constexpr std::array<const char*, 3> channels{"R", "G", "B"};
    for (std::size_t colour = 0; colour < channels.size(); ++colour) {
        Field field = parse_field(bytes, channels[colour], name);
        colours.columns = field.columns;
        colours.rows = field.rows;
        colours.values[colour] = std::move(field.values);
    }
    if (std::min(colours.columns, colours.rows) < patch_side)
        throw Error(fmt::format("'{}' is {} x {}; at least {} pixels in each direction are needed", name,
                                colours.columns, colours.rows, patch_side));
    return colours;
}

Colours read_colours(const std::filesystem::path& path) { return parse_colours(read_file(path), path.string()); }

Window window_of(const Colours& picture, std::size_t side, double scale, double angle, bool wrap) {
    Window window{side, {}, std::vector<bool>(side * side)};
    for (auto& values : window.values) values.assign(side * side, 0.0);
    const auto wide = static_cast<double>(picture.columns), high = static_cast<double>(picture.rows);
    const auto finer = static_cast<std::size_t>(std::clamp(std::ceil(scale), 1.0, 16.0));  // points a pixel and axis
    const double points = static_cast<double>(finer), half = static_cast<double>(side) / 2;
    const auto place_of = [&](double column, double row) {
        const double x = (column - half) * scale, y = (row - half) * scale;
        return Place{wide / 2 + x * std::cos(angle) - y * std::sin(angle),
                     high / 2 + x * std::sin(angle) + y * std::cos(angle)};
    };
    for (std::size_t pixel = 0; pixel < side * side; ++pixel) {
        const auto column = static_cast<double>(pixel % side), row = static_cast<double>(pixel / side);
        const Place middle = place_of(column + 0.5, row + 0.5);
        window.inside[pixel] = wrap || (middle.x > 0 && middle.x < wide && middle.y > 0 && middle.y < high);
        for (std::size_t point = 0; point < finer * finer; ++point) {
            const Place place = place_of(column + (static_cast<double>(point % finer) + 0.5) / points,
                                         row + (static_cast<double>(point / finer) + 0.5) / points);
            for (std::size_t colour = 0; colour < 3; ++colour)
                window.values[colour][pixel] += smooth(picture, colour, place, wrap) / (points * points);
        }
    }
    return window;
}

Window halved(const Window& window) {
    const std::size_t side = window.side, half = side / 2;
    Window smaller{half, {}, std::vector<bool>(half * half)};
    for (std::size_t pixel = 0; pixel < half * half; ++pixel) {
        const std::size_t at = pixel / half * 2 * side + pixel % half * 2;
        smaller.inside[pixel] =
            window.inside[at] && window.inside[at + 1] && window.inside[at + side] && window.inside[at + side + 1];
        for (std::size_t colour = 0; colour < 3; ++colour) {
            const std::vector<double>& from = window.values[colour];
            smaller.values[colour].push_back((from[at] + from[at + 1] + from[at + side] + from[at + side + 1]) / 4);
        }
    }
    return smaller;
}

}  // namespace pelage::learn
