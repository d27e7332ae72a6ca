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

constexpr double deep_steps = 257.0;  // 255 * 257 = 65535

DeepRgb deepened(const Rgb& colour) {
    DeepRgb result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = static_cast<std::uint16_t>(colour[i] * 257);
    return result;
}

// Between two colours of 8 bits, in 8 or 16.
template <class Result>
Result mix(const Rgb& from, const Rgb& to, double share) {
    using Sample = typename Result::value_type;
    constexpr double scale = sizeof(Sample) == 1 ? 1.0 : deep_steps;
    Result result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = static_cast<Sample>(std::lround(scale * (from[i] + share * (to[i] - from[i]))));
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

template <class Result>
Result linear(const std::vector<ColourStop>& stops, double at) {
    const auto above = std::upper_bound(stops.begin(), stops.end(), at,
                                        [](double value, const ColourStop& stop) { return value < stop.at; });
    if (above == stops.begin()) return mix<Result>(stops.front().rgb, stops.front().rgb, 0.0);
    if (above == stops.end()) return mix<Result>(stops.back().rgb, stops.back().rgb, 0.0);
    const auto& below = *(above - 1);
    return mix<Result>(below.rgb, above->rgb, (at - below.at) / (above->at - below.at));
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
        slots.push_back(striped ? constant(stops, at) : linear<Rgb>(stops, at));
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

std::size_t Palette::slot(double above, double range) const {
    const auto last = static_cast<double>(slot_count - 1);
    return static_cast<std::size_t>(std::clamp(last * above / range, 0.0, last));
}

Rgb Palette::operator()(double above, double range) const {
    return slotted_ ? slots_[slot(above, range)] : linear<Rgb>(stops_, std::clamp(above / range, 0.0, 1.0));
}

DeepRgb Palette::deep(double above, double range) const {
    if (slotted_) return deepened((*this)(above, range));
    return linear<DeepRgb>(stops_, std::clamp(above / range, 0.0, 1.0));
}

ValueRange range_of(std::span<const double> values) {
    ValueRange range;
    for (const double value : values) {
        if (std::isfinite(value)) range.widen({value, value});
    }
    return range;
}

Colours::Colours(const Output& output, const ValueRange& found) : palette_(output.colormap) {
    if (output.range) {
        low_ = (*output.range)[0];
        high_ = (*output.range)[1];
    } else if (!found.empty()) {
        low_ = found.low;
        high_ = found.high;
    }
    const double range = high_ - low_;
    flat_ = range == 0.0 || !std::isfinite(slot_count * range) ||
            (palette_.slotted() && !output.range && range < least_slotted_range);
}

Colours::Colours(const Output& output, std::span<const double> values)
    : Colours(output, output.range ? ValueRange{} : range_of(values)) {}

Rgb Colours::operator()(double value) const {
    if (std::isnan(value)) return magenta;
    return flat_ ? grey : palette_(value - low_, high_ - low_);
}

DeepRgb Colours::deep(double value) const {
    if (std::isnan(value)) return deepened(magenta);
    return flat_ ? deepened(grey) : palette_.deep(value - low_, high_ - low_);
}

}  // namespace pelage
