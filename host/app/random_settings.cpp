// See random_settings.hpp.
#include "app/random_settings.hpp"

#include "core/error.hpp"
#include "core/philox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pelage::app {

namespace {

bool drawable(const Parameter& parameter) { return std::isfinite(parameter.low) && std::isfinite(parameter.high); }

std::string drawn(const Parameter& parameter, double uniform) {
    if (parameter.whole) {
        const double low = std::ceil(parameter.low), high = std::floor(parameter.high);
        return fmt::format("{:.0f}", std::min(high, low + std::floor(uniform * (high - low + 1.0))));
    }
    const double value = parameter.low + uniform * (parameter.high - parameter.low);
    const std::string rounded = fmt::format("{:.6g}", value);
    const double read = std::stod(rounded);
    return read < parameter.low || read > parameter.high ? fmt::format("{}", value) : rounded;
}

}  // namespace

std::vector<Setting> random_settings(const Experiment& experiment, std::uint64_t draw) {
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < experiment.parameters.size(); ++i) {
        const Parameter& parameter = experiment.parameters[i];
        if (!drawable(parameter)) continue;
        const auto words = counted_words(i, 0, 0, purpose::parameter, static_cast<std::int64_t>(draw));
        settings.push_back({parameter.name, drawn(parameter, unit_uniform<double>(words[0]))});
    }
    if (settings.empty())
        throw Error(
            fmt::format("{}: no parameter has a range to draw from; write 'define parameter NAME VALUE from LOW "
                        "to HIGH'",
                        experiment.source));
    return settings;
}

}  // namespace pelage::app
