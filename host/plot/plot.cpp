// See plot.hpp.
#include "plot/plot.hpp"

#include "plot/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pelage::bench {

namespace {

// Okabe and Ito's colours: told apart by every eye.
constexpr std::array<Colour, 8> palette{{{0.84, 0.37, 0.00},
                                         {0.00, 0.45, 0.70},
                                         {0.00, 0.62, 0.45},
                                         {0.80, 0.47, 0.65},
                                         {0.90, 0.62, 0.00},
                                         {0.34, 0.71, 0.91},
                                         {0.35, 0.35, 0.35},
                                         {0.60, 0.55, 0.10}}};

constexpr Colour black{0.1, 0.1, 0.1};

std::filesystem::path beside(const std::filesystem::path& file, const char* kind) {
    const bool png = file.extension() == ".png";
    return file.parent_path() / ((png ? file.stem() : file.filename()).string() + kind);
}

double decade_below(double value) { return std::pow(10.0, std::floor(std::log10(value) + 1e-9)); }
double decade_above(double value) { return std::pow(10.0, std::ceil(std::log10(value) - 1e-9)); }

struct Span {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    void take(double value) {
        if (!(value > 0) || !std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    Axis axis(std::string title) const {
        const double least = high > 0 ? decade_below(low) : 1;
        return {std::move(title), least, std::max(high > 0 ? decade_above(high) : 10, 10 * least)};
    }
};

const Yardstick& first_device(const Report& report) {
    return report.yardsticks.size() > 1 ? report.yardsticks[1] : report.yardsticks[0];
}

double best_seconds_an_iteration(const Result& one) { return one.best / static_cast<double>(one.iterations); }

// The most cells a case was measured with, one mark a case and backend.
std::map<std::pair<std::string, std::string>, const Result*> largest(const Report& report) {
    std::map<std::pair<std::string, std::string>, const Result*> found;
    for (const Result& one : report.results) {
        const Result*& kept = found[{one.suite + " " + one.name, one.backend}];
        if (kept == nullptr || one.cells > kept->cells) kept = &one;
    }
    return found;
}

std::map<std::string, Colour> colours_of(const Report& report) {
    std::map<std::string, Colour> colours;
    for (const Result& one : report.results) {
        colours.try_emplace(one.backend, palette[colours.size() % palette.size()]);
    }
    return colours;
}

void draw_roofline(const Report& report, const std::filesystem::path& file) {
    const Yardstick& device = first_device(report);
    const auto marks = largest(report);
    const auto intensity = [](const Result& one) { return one.flops_per_update / one.bytes_per_update; };
    const auto speed = [](const Result& one) { return one.updates_per_second * one.flops_per_update / 1e9; };
    Span x, y;
    x.take(0.5);
    x.take(20);
    y.take(device.peak / 1e9);
    for (const auto& [key, one] : marks) {
        x.take(intensity(*one));
        y.take(speed(*one));
    }
    Diagram diagram("Roofline of " + device.device,
                    x.axis("operations a byte, each array read or written once an iteration"), y.axis("GFLOP/s"));
    const double low = decade_below(x.low), high = decade_above(x.high);
    const double ridge = device.peak / device.copy_bandwidth;
    diagram.line({{low, low * device.copy_bandwidth / 1e9}, {ridge, device.peak / 1e9}, {high, device.peak / 1e9}},
                 black);
    diagram.legend(fmt::format("copy {:.1f} GB/s", device.copy_bandwidth / 1e9), black);
    diagram.legend(fmt::format("fma {:.0f} GFLOP/s", device.peak / 1e9), black);
    const auto colours = colours_of(report);
    for (const auto& [backend, colour] : colours) diagram.legend(backend, colour);
    for (const auto& [key, one] : marks) {
        diagram.dots({{intensity(*one), speed(*one)}}, colours.at(one->backend));
        if (one->backend == "opencl") diagram.label({intensity(*one), speed(*one)}, one->name);
    }
    diagram.write(file);
}

// The first case of each suite but growth, whose cells change while it runs.
std::vector<std::string> scaling_cases(const Report& report) {
    std::vector<std::string> suites, names;
    for (const Result& one : report.results) {
        if (one.suite == "growth" || std::ranges::find(suites, one.suite) != suites.end()) continue;
        suites.push_back(one.suite);
        names.push_back(one.name);
    }
    return names;
}

void draw_scaling(const Report& report, const std::filesystem::path& file) {
    constexpr std::array dashes{Dash::none, Dash::dashed, Dash::dotted};
    const auto colours = colours_of(report);
    std::map<std::pair<std::size_t, std::string>, std::vector<Spot>> curves;  // by place of the case, and backend
    const std::vector<std::string> names = scaling_cases(report);
    Span x, y;
    for (const Result& one : report.results) {
        const auto place = static_cast<std::size_t>(std::ranges::find(names, one.name) - names.begin());
        if (place == names.size()) continue;
        const Spot spot{static_cast<double>(one.cells), 1e3 * best_seconds_an_iteration(one)};
        curves[{place, one.backend}].push_back(spot);
        x.take(spot.x);
        y.take(spot.y);
    }
    Diagram diagram("Time of one iteration on " + first_device(report).device, x.axis("cells"), y.axis("milliseconds"));
    for (auto& [key, spots] : curves) {
        std::ranges::sort(spots, {}, &Spot::x);
        const Colour colour = colours.at(key.second);
        const Dash dash = dashes[key.first % dashes.size()];
        diagram.line(spots, colour, dash);
        diagram.dots(spots, colour);
        diagram.legend(names[key.first] + ", " + key.second, colour, dash);
    }
    diagram.write(file);
}

}  // namespace

std::filesystem::path roofline_file(const std::filesystem::path& file) { return beside(file, ".roofline.png"); }
std::filesystem::path scaling_file(const std::filesystem::path& file) { return beside(file, ".scaling.png"); }

void plot(const Report& report, const std::filesystem::path& file) {
    draw_roofline(report, roofline_file(file));
    draw_scaling(report, scaling_file(file));
}

}  // namespace pelage::bench
