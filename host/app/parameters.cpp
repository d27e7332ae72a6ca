// See parameters.hpp.
#include "app/parameters.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::app {

namespace {

nlohmann::ordered_json bound(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

std::string line_of(const Parameter& one, std::size_t width) {
    std::string text = fmt::format("  {:<{}}  {}", one.name, width, one.value);
    if (one.value != one.usual) text += fmt::format(" (default {})", one.usual);
    if (std::isfinite(one.low)) text += fmt::format(" from {} to {}", one.low, one.high);
    return text + (one.meaning.empty() ? "" : ": " + one.meaning) + "\n";
}

}  // namespace

std::string parameters_text(const Experiment& experiment) {
    if (experiment.parameters.empty()) return fmt::format("{}: no parameters\n", experiment.source);
    std::size_t width = 0;
    for (const Parameter& one : experiment.parameters) width = std::max(width, one.name.size());
    std::string text = experiment.source + ":\n";
    for (const Parameter& one : experiment.parameters) text += line_of(one, width);
    return text;
}

nlohmann::ordered_json parameters_json(const Experiment& experiment) {
    auto list = nlohmann::ordered_json::array();
    for (const Parameter& one : experiment.parameters) {
        list.push_back({{"name", one.name},
                        {"value", one.value},
                        {"default", one.usual},
                        {"low", bound(one.low)},
                        {"high", bound(one.high)},
                        {"meaning", one.meaning},
                        {"line", one.line}});
    }
    return {{"experiment", experiment.source}, {"parameters", list}};
}

}  // namespace pelage::app
