// See resampling.hpp.
#include "core/resampling.hpp"

#include <algorithm>
#include <array>

namespace pelage {

namespace {

std::size_t others_of(Interpolation interpolation) {
    switch (interpolation) {
        case Interpolation::nearest:
            return 0;
        case Interpolation::bilinear:
            return 1;
        default:
            return 3;
    }
}

// Of the elements at +1, -1 and +2 from the base, for a place that lies t past it.
std::array<double, 3> weights_at(Interpolation interpolation, double t) {
    if (interpolation == Interpolation::bilinear) return {t, 0.0, 0.0};
    return {((-1.5 * t + 2.0) * t + 0.5) * t, ((-0.5 * t + 1.0) * t - 0.5) * t, (0.5 * t - 0.5) * t * t};
}

std::int32_t within(std::int64_t place, bool wrap, std::int64_t places) {
    const std::int64_t inside =
        wrap ? (place % places + places) % places : std::clamp(place, std::int64_t{0}, places - 1);
    return static_cast<std::int32_t>(inside);
}

}  // namespace

Sampling sampling(Interpolation interpolation, bool wrap, std::size_t old_places, std::size_t new_places) {
    static constexpr std::array<std::int64_t, 3> steps{1, -1, 2};
    const auto from = static_cast<std::int64_t>(old_places);
    const auto to = static_cast<std::int64_t>(new_places);
    Sampling sampling{new_places, others_of(interpolation), {}, {}, {}};
    for (std::int64_t place = 0; place < to; ++place) {
        const std::int64_t middle = (2 * place + 1) * from;  // in units of 1 / (2 to), as is what follows
        const auto nearest = static_cast<std::int32_t>(middle / (2 * to));
        sampling.nearest.push_back(nearest);
        const std::int64_t base = middle < to ? -1 : (middle - to) / (2 * to);
        sampling.sources.push_back(sampling.others == 0 ? nearest : within(base, wrap, from));
        const double t = static_cast<double>(middle - to - base * 2 * to) / static_cast<double>(2 * to);
        const auto weights = weights_at(interpolation, t);
        for (std::size_t other = 0; other < sampling.others; ++other) {
            sampling.sources.push_back(within(base + steps[other], wrap, from));
            sampling.weights.push_back(weights[other]);
        }
    }
    return sampling;
}

}  // namespace pelage
