// From values to colours.
#pragma once

#include "core/experiment.hpp"
#include "io/picture.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

namespace pelage {

inline constexpr Rgb grey{128, 128, 128};
inline constexpr Rgb magenta{255, 0, 255};

// A colormap as a function on [0, 1]. heat, striped and gradient have 100 slots as published; striped holds a slot's
// colour up to the next one, gradient is linear in between, the first colour reaches down to slot 0 and the last one up
// to slot 99. inferno, viridis, magma and gray are linear between control points, within 2 % of their originals;
// "stops" is linear between its stops. Throws Error on another name, and on stops that are missing or outside [0, 1].
class Palette {
public:
    explicit Palette(const Colormap&);

    bool slotted() const { return slotted_; }
    const std::vector<ColourStop>& stops() const { return stops_; }  // of a linear map, ascending
    const std::vector<Rgb>& slots() const { return slots_; }         // of a slotted map
    // Of a value that lies `above` the low end of a range; beyond its ends the end slots, and the end colours.
    std::size_t slot(double above, double range) const;  // of a slotted map
    Rgb operator()(double above, double range) const;
    DeepRgb deep(double above, double range) const;  // 16 bits: linear maps have more colours

private:
    bool slotted_ = false;
    std::vector<ColourStop> stops_;  // ascending
    std::vector<Rgb> slots_;         // 100, or none
};

// From the lowest to the highest value that is drawn.
struct ValueRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    bool empty() const { return !(low <= high); }
    void widen(const ValueRange& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
    bool operator==(const ValueRange&) const = default;
};

// Minimum to maximum of the finite values; empty where there are none.
ValueRange range_of(std::span<const double> values);

// The colour of a value: its place in a range. What lies outside takes the colour of the range's nearer end, a NaN is
// magenta. Where the range is not the output's own but found from values, 50 % grey stands for "all equal": low ==
// high, and with a slotted map, as published, a range below 1e-4.
class Colours {
public:
    // The range is the output's own, else `found`.
    Colours(const Output&, const ValueRange& found);
    // The range is the output's own, else that of the values.
    Colours(const Output&, std::span<const double> values);

    double low() const { return low_; }
    double high() const { return high_; }
    bool flat() const { return flat_; }  // every value is grey
    const Palette& palette() const { return palette_; }
    Rgb operator()(double value) const;
    DeepRgb deep(double value) const;  // 16 bits; linear maps have colours between those of 8 bits

private:
    Palette palette_;
    double low_ = 0.0;
    double high_ = 0.0;
    bool flat_ = false;
};

}  // namespace pelage
