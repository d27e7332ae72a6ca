// See course.hpp.
#include "stats/course.hpp"

#include "core/error.hpp"
#include "stats/excess.hpp"

#include <algorithm>
#include <cmath>

namespace pelage::stats {

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::uniform:
            return "uniform";
        case Verdict::stationary:
            return "stationary";
        case Verdict::oscillating:
            return "oscillating";
        case Verdict::moving:
            return "moving";
        case Verdict::undecided:
            return "undecided";
        case Verdict::not_a_number:
            return "NaN";
        case Verdict::unstable:
            return "unstable";
    }
    return "";
}

void Course::make_room(int excess) {
    if (excess <= excess_) return;
    const int less = excess_ - excess;
    for (double& sum : sum_) sum = std::ldexp(sum, less);
    for (double& square : squares_) square = std::ldexp(square, 2 * less);
    largest_ = std::ldexp(largest_, less);
    largest_span_ = std::ldexp(largest_span_, less);
    excess_ = excess;
}

void Course::show(const Grid& grid) {
    check(grid);
    if (states_ > 0 && sum_.size() != grid.values.size()) throw Error("a pattern that is followed keeps its size");
    make_room(excess_of(grid.values));
    sum_.resize(grid.values.size());
    squares_.resize(grid.values.size());
    for (std::size_t cell = 0; cell < sum_.size(); ++cell) {
        const double value = std::ldexp(grid.values[cell], -excess_);
        sum_[cell] += value;
        squares_[cell] += value * value;
        largest_ = std::max(largest_, std::fabs(value));
    }
    const auto [low, high] = std::minmax_element(grid.values.begin(), grid.values.end());
    largest_span_ = std::max(largest_span_, std::ldexp(*high, -excess_) - std::ldexp(*low, -excess_));
    ++states_;
}

Verdict Course::verdict(double scale) const {
    if (states_ < 2) throw Error("what a pattern does in time shows in two states or more");
    const double states = static_cast<double>(states_), cells = static_cast<double>(sum_.size());
    double mean = 0.0;
    for (const double sum : sum_) mean += sum / states / cells;
    double in_space = 0.0, in_time = 0.0;
    for (std::size_t cell = 0; cell < sum_.size(); ++cell) {
        const double middle = sum_[cell] / states;
        in_space += (middle - mean) * (middle - mean) / cells;
        in_time += std::max(0.0, squares_[cell] / states - middle * middle) / cells;
    }
    const double small = std::max(1e-3 * largest_, 1e-6 * std::ldexp(scale, -excess_));
    const bool flat = largest_span_ <= small;
    if (flat && in_time <= small * small) return Verdict::uniform;
    if (flat) return Verdict::oscillating;
    if (in_time <= 1e-4 * (in_space + in_time)) return Verdict::stationary;
    return in_space < in_time ? Verdict::moving : Verdict::oscillating;
}

double change(const Grid& before, const Grid& after) {
    if (before.values.size() != after.values.size()) return 1.0;
    const int excess = std::max(excess_of(before.values), excess_of(after.values));
    const auto scaled = [&](double value) { return std::ldexp(value, -excess); };
    double sum = 0.0;
    for (std::size_t cell = 0; cell < after.values.size(); ++cell)
        sum += std::fabs(scaled(after.values[cell]) - scaled(before.values[cell]));
    if (sum == 0.0) return 0.0;
    const auto [low, high] = std::minmax_element(after.values.begin(), after.values.end());
    const double lowest = scaled(*low), highest = scaled(*high);
    const double scale = std::max(highest - lowest, 1e-3 * std::max(std::fabs(lowest), std::fabs(highest)));
    return sum / static_cast<double>(after.values.size()) / scale;
}

}  // namespace pelage::stats
