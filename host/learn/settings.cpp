// See settings.hpp.
#include "learn/settings.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace pelage::learn {

namespace {

void check_positive(const char* option, double value) {
    if (value > 0 && std::isfinite(value)) return;
    throw Error(fmt::format("{} {} is not allowed; allowed are numbers above 0", option, value));
}

}  // namespace

void check(const Settings& settings) {
    check_learning(settings.shape);
    check_positive("--rate", settings.rate);
    check_positive("--drop", settings.drop);
    if (settings.scale != 0) check_positive("--scale", settings.scale);
    if (!(settings.overflow >= 0) || !std::isfinite(settings.overflow))
        throw Error(fmt::format("--overflow {} is not allowed; allowed are 0 and more", settings.overflow));
    if (settings.fewest < 1 || settings.fewest > settings.most)
        throw Error(
            fmt::format("--iterations {}:{} is not allowed; the first number is at least 1 and at most the second",
                        settings.fewest, settings.most));
    if (settings.pool < settings.shape.batch)
        throw Error(fmt::format("--pool {} is smaller than --batch {}", settings.pool, settings.shape.batch));
}

std::string identity(const Settings& settings) {
    const LearningShape& shape = settings.shape;
    return fmt::format(
        "--size {} --batch {} --chemicals {} --hidden {} --rotations {} --pool {} --seed-every {} --iterations {}:{} "
        "--rate {} --drop {} --drop-at {} --overflow {} --scale {} {}--seed {}",
        shape.side, shape.batch, shape.chemicals, shape.hidden, shape.rotations, settings.pool, settings.seed_every,
        settings.fewest, settings.most, settings.rate, settings.drop, fmt::join(settings.drops, ","), settings.overflow,
        settings.scale, settings.wrap ? "--wrap " : "", settings.seed);
}

double planned_rate(const Settings& settings, std::uint64_t step) {
    const auto passed = std::ranges::count_if(settings.drops, [step](std::uint64_t one) { return step > one; });
    return settings.rate * std::pow(settings.drop, static_cast<double>(passed));
}

double bytes_needed(const Settings& settings) {
    const LearningShape& shape = settings.shape;
    const double number = sizeof(float);
    const double state = number * static_cast<double>(shape.states());
    const double pool = number * static_cast<double>(settings.pool * shape.sample());
    const auto kept = keeping(settings.most, state, static_cast<double>(settings.memory)).states();
    const double sums = number * static_cast<double>(shape.batch * cell_runs * sum_lanes * shape.weights());
    const double hidden = 2 * number * static_cast<double>(shape.batch * shape.cells() * shape.hidden);
    const double ranked = number * static_cast<double>(direction_sets * shape.rotations * patch_directions *
                                                       shape.level_begin(pyramid_levels));
    return pool + state * static_cast<double>(kept + 4) + sums + hidden + 2 * ranked;
}

}  // namespace pelage::learn
