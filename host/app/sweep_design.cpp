// See sweep_design.hpp.
#include "app/sweep_design.hpp"

#include "app/named_files.hpp"
#include "app/settings.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pelage::app {

namespace {

std::vector<sweep::Point> sampled(const SweepOptions& options) {
    std::vector<sweep::Range> ranges;
    for (const std::string& word : options.vary) ranges.push_back(sweep::parse_range(word));
    if (ranges.empty()) throw Error("--samples draws within the ranges of --vary; give at least one");
    return sweep::samples(ranges, options.samples, options.latin,
                          static_cast<std::uint64_t>(options.run.seed.value_or(1)));
}

std::vector<sweep::Axis> axes_of(const SweepOptions& options) {
    if (options.latin) throw Error("--latin says how samples are drawn; give their number with --samples");
    std::vector<sweep::Axis> axes;
    for (const std::string& word : options.vary) axes.push_back(sweep::parse_axis(word));
    if (options.across > 0 && !axes.empty())
        throw Error("--across lays out points or samples; the tiles of a grid lie along its axes");
    if (axes.empty() && options.replicates == 1)
        throw Error("nothing varies; give --vary NAME=LOW:HIGH:COUNT, --points FILE or --replicates N");
    return axes;
}

void make_whole(std::vector<sweep::Point>& points, const Experiment& plain) {
    for (sweep::Point& point : points) {
        for (Setting& one : point.settings) {
            const auto parameter = std::ranges::find(plain.parameters, one.name, &Parameter::name);
            if (parameter != plain.parameters.end() && parameter->whole)
                one.value = fmt::format("{:.0f}", std::round(std::stod(one.value)));
        }
    }
}

}  // namespace

SweepDesign sweep_design(const SweepOptions& options, const Experiment& plain) {
    SweepDesign design;
    if (!options.points.empty()) {
        if (!options.vary.empty()) throw Error("--points gives all values; leave --vary out, or --points");
        if (options.samples > 0 || options.latin)
            throw Error("--points gives all values, and none is drawn; leave --samples and --latin out, or --points");
        for (const std::string& file : {std::string("sweep.csv"), "sheet." + options.sheet})
            keep_inputs("the sweep's result", options.run.folder() / file, {options.points}, "what --points reads");
        design.points = sweep::read_points(options.points);
    } else if (options.samples > 0) {
        design.points = sampled(options);
        make_whole(design.points, plain);
    } else {
        design.axes = axes_of(options);
        design.points = sweep::grid(design.axes, options.replicates);
    }
    for (const Setting& one : design.points.front().settings) design.names.push_back(one.name);
    for (const Setting& one : settings_of(options.run.settings)) {
        if (std::ranges::find(design.names, one.name) != design.names.end())
            throw Error(fmt::format("--set {}={}: {} gives '{}' its values; leave one of the two out", one.name,
                                    one.value, options.points.empty() ? "--vary" : "--points", one.name));
    }
    return design;
}

std::string blamed(const SweepOptions& options, const std::string& name) {
    return options.points.empty() ? "--vary " + name : fmt::format("--points {}: {}", options.points.string(), name);
}

void check_ranges(const SweepOptions& options, const SweepDesign& design, const Experiment& experiment) {
    for (std::size_t n = 0; n < design.points.size(); ++n) {
        for (const Setting& one : design.points[n].settings) {
            const auto parameter = std::ranges::find(experiment.parameters, one.name, &Parameter::name);
            if (parameter == experiment.parameters.end()) continue;
            const double value = std::stod(one.value);
            const bool within = value >= parameter->low && value <= parameter->high;
            if (within && (!parameter->whole || value == std::floor(value))) continue;
            const std::string row = options.points.empty() ? "" : fmt::format(" (point {})", n + 1);
            throw Error(fmt::format("{}{}: {} is {}; parameter '{}' must be a {} from {:g} to {:g}",
                                    blamed(options, one.name), row, one.value,
                                    within ? "not a whole number" : "out of range", one.name,
                                    parameter->whole ? "whole number" : "number", parameter->low, parameter->high));
        }
    }
}

std::optional<double> steady_tolerance(const SweepOptions& options) {
    if (options.until.empty()) return std::nullopt;
    double value = 0.0;
    const std::string& text = options.until.back();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc{} && end == text.data() + text.size() && value > 0.0 && value < 1.0;
    if (options.until.size() != 2 || options.until.front() != "steady" || !number)
        throw Error("--until is written --until steady TOLERANCE, with a tolerance between 0 and 1, as in 1e-4");
    return value;
}

}  // namespace pelage::app
