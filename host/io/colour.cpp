// See colour.hpp.
#include "io/colour.hpp"

#include "core/error.hpp"
#include "io/colormaps.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

constexpr double least_slotted_range = 1e-4;

Rgb mix(const Rgb& from, const Rgb& to, double share) {
    Rgb result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = static_cast<std::uint8_t>(std::lround(from[i] + share * (to[i] - from[i])));
    }
    return result;
}

std::vector<ColourStop> sorted_stops(const Colormap& map) {
    auto stops = map.stops;
    if (stops.empty()) throw Error(fmt::format("colormap '{}' has no colours; at least one is needed", map.name));
    for (const auto& stop : stops) {
        if (stop.at >= 0.0 && stop.at <= 1.0) continue;
        throw Error(fmt::format("colormap '{}' has a colour at {}; allowed is 0 to 1", map.name, stop.at));
    }
    std::stable_sort(stops.begin(), stops.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    return stops;
}

Rgb linear(const std::vector<ColourStop>& stops, double at) {
    const auto above = std::upper_bound(stops.begin(), stops.end(), at,
                                        [](double value, const ColourStop& stop) { return value < stop.at; });
    if (above == stops.begin()) return stops.front().rgb;
    if (above == stops.end()) return stops.back().rgb;
    const auto& below = *(above - 1);
    return mix(below.rgb, above->rgb, (at - below.at) / (above->at - below.at));
}

Rgb constant(const std::vector<ColourStop>& stops, double at) {
    Rgb colour = stops.front().rgb;
    for (const auto& stop : stops) {
        if (stop.at <= at) colour = stop.rgb;
    }
    return colour;
}

std::vector<Rgb> fill_slots(std::vector<ColourStop> stops, bool striped) {
    const auto last = static_cast<double>(slot_count - 1);
    for (auto& stop : stops) stop.at = std::round(stop.at * last);
    std::vector<Rgb> slots;
    for (std::size_t i = 0; i < slot_count; ++i) {
        const auto at = static_cast<double>(i);
        // The last slot always has the last colour; a stripe that begins there is one slot wide.
        slots.push_back(striped ? constant(stops, at) : linear(stops, at));
    }
    return slots;
}

}  // namespace

Palette::Palette(const Colormap& map)
    : slotted_(map.name == "heat" || map.name == "striped" || map.name == "gradient") {
    if (map.name == "heat") {
        slots_ = heat_slots();
    } else if (slotted_) {
        slots_ = fill_slots(sorted_stops(map), map.name == "striped");
    } else {
        stops_ = map.name == "stops" ? sorted_stops(map) : named_stops(map.name);
        if (!stops_.empty()) return;
        throw Error(
            fmt::format("unknown colormap '{}'; allowed are heat, gradient, striped, inferno, viridis, magma, gray "
                        "and stops",
                        map.name));
    }
}

Rgb Palette::operator()(double above, double range) const {
    if (slotted_) return slots_[static_cast<std::size_t>(static_cast<double>(slot_count - 1) * above / range)];
    return linear(stops_, above / range);
}

Colours::Colours(const Output& output, std::span<const double> values) : palette_(output.colormap) {
    if (output.range) {
        low_ = (*output.range)[0];
        high_ = (*output.range)[1];
        return;
    }
    low_ = std::numeric_limits<double>::infinity();
    high_ = -low_;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    if (low_ > high_) low_ = high_ = 0.0;
}

Rgb Colours::operator()(double value) const {
    if (std::isnan(value)) return magenta;
    const double range = high_ - low_;
    if (!std::isfinite(slot_count * range)) return grey;
    if (palette_.slotted()) {
        if (range < least_slotted_range || value < low_ || value > high_) return grey;
        return palette_(value - low_, range);
    }
    if (range == 0.0) return grey;
    return palette_(std::clamp((value - low_) / range, 0.0, 1.0), 1.0);
}

Picture render(std::span<const double> values, std::size_t columns, std::size_t rows, const Output& output) {
    if (values.size() != columns * rows) {
        throw Error(fmt::format("{} values cannot be drawn as {} x {} pixels", values.size(), columns, rows));
    }
    const Colours colours(output, values);
    Picture picture(columns, rows);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            picture.at(column, rows - 1 - row) = colours(values[row * columns + column]);
        }
    }
    return picture;
}

}  // namespace pelage
