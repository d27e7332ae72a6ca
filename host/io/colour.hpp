// From values to colours.
#pragma once

#include "core/experiment.hpp"
#include "io/picture.hpp"

#include <array>
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
    // Of a value that lies `above` the low end of a range: 0 <= above / range <= 1.
    Rgb operator()(double above, double range) const;

private:
    bool slotted_ = false;
    std::vector<ColourStop> stops_;  // ascending
    std::vector<Rgb> slots_;         // 100, or none
};

// The colour of a value: its place in [low, high]. A NaN is magenta. As published, a slotted map shows what lies
// outside and everything, when the range is below 1e-4, as 50 % grey; other maps keep their end colours outside, and
// are grey where low == high.
class Colours {
public:
    // The range is the output's own, else minimum to maximum of the finite values.
    Colours(const Output&, std::span<const double> values);

    double low() const { return low_; }
    double high() const { return high_; }
    Rgb operator()(double value) const;

private:
    Palette palette_;
    double low_ = 0.0;
    double high_ = 0.0;
};

// One pixel a value; `values` has the bottom row first, the picture the top line.
Picture render(std::span<const double> values, std::size_t columns, std::size_t rows, const Output&);

}  // namespace pelage
