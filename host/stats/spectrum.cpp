// See spectrum.hpp.
#include "stats/spectrum.hpp"

#include <kissfft/kissfft.hh>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace pelage::stats {

namespace {

using Complex = std::complex<double>;

double taper(std::size_t place, std::size_t count) {
    const double turn = 2.0 * std::numbers::pi * (static_cast<double>(place) + 0.5) / static_cast<double>(count);
    return count < 3 ? 1.0 : 0.5 * (1.0 - std::cos(turn));
}

std::vector<Complex> centred(const Grid& grid) {
    const auto weight = [&](std::size_t cell) {
        return grid.wrap ? 1.0 : taper(cell % grid.columns, grid.columns) * taper(cell / grid.columns, grid.rows);
    };
    double sum = 0.0, weights = 0.0;
    for (std::size_t cell = 0; cell < grid.values.size(); ++cell) {
        sum += weight(cell) * grid.values[cell];
        weights += weight(cell);
    }
    std::vector<Complex> field(grid.values.size());
    for (std::size_t cell = 0; cell < field.size(); ++cell)
        field[cell] = weight(cell) * (grid.values[cell] - sum / weights);
    return field;
}

void transform(std::vector<Complex>& field, std::size_t columns, std::size_t rows) {
    const kissfft<double> along(columns, false), up(rows, false);
    std::vector<Complex> line(std::max(columns, rows)), turned(line.size());
    for (std::size_t row = 0; row < rows; ++row) {
        along.transform(&field[row * columns], turned.data());
        std::copy_n(turned.begin(), columns, field.begin() + static_cast<std::ptrdiff_t>(row * columns));
    }
    for (std::size_t column = 0; column < columns; ++column) {
        for (std::size_t row = 0; row < rows; ++row) line[row] = field[row * columns + column];
        up.transform(line.data(), turned.data());
        for (std::size_t row = 0; row < rows; ++row) field[row * columns + column] = turned[row];
    }
}

// Waves a cell, from -1/2 to 1/2.
double frequency(std::size_t place, std::size_t count) {
    const double n = static_cast<double>(count);
    return (place <= count / 2 ? static_cast<double>(place) : static_cast<double>(place) - n) / n;
}

// Calls visit(x, y, power) for each wave.
template <class Visit>
void each_wave(const std::vector<Complex>& field, const Grid& grid, Visit&& visit) {
    for (std::size_t cell = 1; cell < field.size(); ++cell)
        visit(frequency(cell % grid.columns, grid.columns), frequency(cell / grid.columns, grid.rows),
              std::norm(field[cell]));
}

// The entry with most power; 0: there is none.
std::size_t highest(const std::vector<double>& radial) {
    const auto at = std::max_element(radial.begin() + 1, radial.end());
    return *at > 0.0 ? static_cast<std::size_t>(at - radial.begin()) : 0;
}

}  // namespace

Waves waves_of(const Grid& grid) {
    check(grid);
    Waves waves;
    const double longer = static_cast<double>(std::max(grid.columns, grid.rows));
    // The shortest wave is a checkerboard's, of the root of 2.
    waves.radial.assign(static_cast<std::size_t>(longer * std::numbers::sqrt2 / 2.0) + 2, 0.0);
    std::vector<Complex> field = centred(grid);
    const auto [low, high] = std::minmax_element(grid.values.begin(), grid.values.end());
    if (*high - *low <= 1e-12 * std::max(std::fabs(*low), std::fabs(*high))) return waves;
    transform(field, grid.columns, grid.rows);
    each_wave(field, grid, [&](double x, double y, double power) {
        const double place = std::hypot(x, y) * longer;
        const auto entry = static_cast<std::size_t>(std::lround(place));
        if (entry > 0 && entry < waves.radial.size()) waves.radial[entry] += power;
    });
    const std::size_t top = highest(waves.radial);
    if (top == 0) return waves;
    double near = 0.0, number = 0.0;  // power around the top, and its mean wave number
    each_wave(field, grid, [&](double x, double y, double power) {
        const double place = std::hypot(x, y) * longer;
        if (std::fabs(place - static_cast<double>(top)) > 1.75) return;
        near += power;
        number += power * place;
    });
    number /= near;
    waves.wavelength = longer / number;
    double total = 0.0;
    Complex turned = 0.0;
    each_wave(field, grid, [&](double x, double y, double power) {
        const double place = std::hypot(x, y) * longer;
        if (place < 0.75 * number - 0.5 || place > 1.25 * number + 0.5) return;
        total += power;
        turned += power * std::polar(1.0, 2.0 * std::atan2(y, x));
    });
    waves.anisotropy = total > 0.0 ? std::abs(turned) / total : 0.0;
    const double angle = std::arg(turned) * 90.0 / std::numbers::pi;
    waves.direction = std::fabs(angle) < 1e-6 ? 0.0 : angle < 0.0 ? angle + 180.0 : angle;
    return waves;
}

}  // namespace pelage::stats
