// See check.hpp: in which order the bins of the neighbour search put points. Lists are right in a box that is too
// small, too: what lies beyond is kept in its last bins, which are then crowded.
#include "opencl/device/cl_error.hpp"
#include "opencl/neighbours/bins.hpp"
#include "verify/check.hpp"
#include "verify/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace pelage::verify {

namespace {

constexpr float reach = 3.0f;

// Bins along one axis, as kernels/neighbours/bins.cl lays them over few points.
class Axis {
public:
    explicit Axis(const std::vector<float>& places)
        : corner_(std::ranges::min(places)), extent_(std::ranges::max(places) - corner_) {
        const float bins = extent_ / reach;
        if (extent_ > 0) per_ = 1 / (reach * (1.001f + bins * 0x1p-21f));
    }

    std::size_t bins() const { return static_cast<std::size_t>(extent_ * per_ + 1); }
    std::size_t bin(float place) const {
        return std::min(static_cast<std::size_t>((place - corner_) * per_), bins() - 1);
    }

private:
    float corner_, extent_, per_ = 0.0f;
};

// Bin by bin, row by row of them; in a bin as they were given.
std::vector<std::uint32_t> expected_order(const std::vector<float>& x, const std::vector<float>& y) {
    const Axis across(x), up(y);
    std::vector<std::uint32_t> order(x.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(
        order, {}, [&](std::uint32_t point) { return up.bin(y[point]) * across.bins() + across.bin(x[point]); });
    return order;
}

std::vector<std::uint32_t> found_order(const Session& on, const std::vector<float>& x, const std::vector<float>& y,
                                       const NeighbourTuning& tuning) {
    return with_device(on.info().name, [&] {
        const std::size_t bytes = x.size() * sizeof(float);
        const cl::Buffer positions = on.buffer(2 * bytes, "positions");
        on.queue().enqueueWriteBuffer(positions, CL_TRUE, 0, bytes, x.data());
        on.queue().enqueueWriteBuffer(positions, CL_TRUE, bytes, bytes, y.data());
        NeighbourBins bins(on, tuning);
        const auto points = static_cast<int>(x.size());
        bins.sort(positions, points, points, reach);
        std::vector<std::uint32_t> order(x.size());
        on.queue().enqueueReadBuffer(bins.order(), CL_TRUE, 0, order.size() * sizeof(cl_int), order.data());
        return order;
    });
}

// One of them, the first or the last, lies far beyond all others.
Points one_far(std::size_t count, std::pair<double, double> off, bool first) {
    Points points = jittered(count, 3);
    const auto beyond = [&](std::vector<double>& places, double by) {
        const auto [least, most] = std::ranges::minmax(places);
        places[first ? 0 : count - 1] = by < 0 ? least + by : by > 0 ? most + by : (least + most) / 2;
    };
    beyond(points.x, off.first);
    beyond(points.y, off.second);
    return points;
}

Outcome check_order(Place& place) {
    if (!place.device().correctly_rounded_divide_sqrt)
        return {Verdict::skipped, {}, "the device's quotients are not rounded correctly, so its bins may differ", {}};
    const NeighbourTuning own = NeighbourTuning::of(place.session());
    NeighbourTuning chunks = own, tickets = own;
    chunks.tickets = false;
    chunks.chunks = 7;
    chunks.per_chunk = 5;
    tickets.tickets = true;
    tickets.bits = 4;
    Outcome outcome;
    const auto compare = [&](const Points& points, const std::string& what) {
        const std::vector<float> x(points.x.begin(), points.x.end()), y(points.y.begin(), points.y.end());
        const std::vector<std::uint32_t> expected = expected_order(x, y);
        for (const NeighbourTuning& tuning : {own, chunks, tickets}) {
            add(outcome.tally, expected, found_order(place.session(), x, y, tuning),
                fmt::format("order of {}, {} chunks{}", what, tuning.chunks, tuning.tickets ? " or tickets" : ""));
        }
    };
    for (const std::size_t count : {40u, 601u}) {
        if (place.small() && count > 40) continue;
        for (const auto& off : {std::pair{-9.0, 0.0}, {9.0, 0.0}, {0.0, -9.0}, {0.0, 9.0}}) {
            for (const bool first : {false, true}) {
                compare(one_far(count, off, first), fmt::format("{} points, the {} off by ({}, {})", count,
                                                                first ? "first" : "last", off.first, off.second));
            }
        }
    }
    conclude(outcome);
    return outcome;
}

}  // namespace

std::vector<Check> order_checks() { return {{"neighbours/order", "neighbour search", true, check_order}}; }

}  // namespace pelage::verify
