// See settings.hpp.
#include "learn/settings.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::learn {

namespace {

void check_real(const RealLimit& limit, double value) {
    if (limit.allows(value)) return;
    throw Error(fmt::format("{} {} is not allowed; allowed is {}", limit.option, value, allowed(limit)));
}

void check_drops(const Settings& settings) {
    std::uint64_t before = 0;
    for (const std::uint64_t step : settings.drops) {
        check_limit(limits::drop_at, step);
        if (step <= before)
            throw Error(
                fmt::format("--drop-at {} is not allowed; each step comes after the one before, and {} does not",
                            fmt::join(settings.drops, ","), step));
        before = step;
    }
    // The rate is largest or smallest in the end.
    const double last = planned_rate(settings, settings.steps);
    if (last >= std::numeric_limits<float>::min() && last <= std::numeric_limits<float>::max()) return;
    throw Error(fmt::format(
        "--rate {} comes to {:.3g} by --drop {}; single precision holds numbers from {:.3g} to {:.3g}", settings.rate,
        last, settings.drop, std::numeric_limits<float>::min(), std::numeric_limits<float>::max()));
}

}  // namespace

std::string allowed(const RealLimit& limit) { return fmt::format("a number from {} to {}", limit.least, limit.most); }

void check(const Settings& settings) {
    check_learning(settings.shape);
    check_limit(limits::steps, settings.steps);
    check_limit(limits::pool, settings.pool);
    check_limit(limits::seed_every, settings.seed_every);
    check_real(limits::rate, settings.rate);
    check_real(limits::drop, settings.drop);
    if (settings.scale) check_real(limits::scale, *settings.scale);
    check_real(limits::overflow, settings.overflow);
    check_drops(settings);
    for (const std::size_t number : {settings.fewest, settings.most}) check_limit(limits::iterations, number);
    if (settings.fewest > settings.most)
        throw Error(fmt::format("--iterations {}:{} is not allowed; the first number is at most the second",
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
        settings.scale.value_or(0.0), settings.wrap ? "--wrap " : "", settings.seed);
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
