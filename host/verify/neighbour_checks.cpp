// See check.hpp: the search for neighbours.
#include "opencl/neighbours/neighbours.hpp"
#include "reference/neighbours/neighbours.hpp"
#include "verify/check.hpp"
#include "verify/points.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::verify {

namespace {

std::vector<std::uint32_t> flat(const Neighbours& neighbours) {
    std::vector<std::uint32_t> words(neighbours.first.begin(), neighbours.first.end());
    words.insert(words.end(), neighbours.ids.begin(), neighbours.ids.end());
    return words;
}

Neighbours by_tree(const Points& points, float radius) {
    const std::vector<float> x(points.x.begin(), points.x.end());
    const std::vector<float> y(points.y.begin(), points.y.end());
    return neighbours_exact<float>(x, y, radius);
}

// As on a CPU, and as on a GPU: no vectors, many short chunks, a sort of several passes.
std::vector<NeighbourTuning> tunings(Place& place, bool both) {
    const std::size_t most = place.device().max_work_group;
    const NeighbourTuning own = NeighbourTuning::of(place.session());
    if (!both) return {own};
    if (own.width == 1) return {own, {1, 3, 100, 0, std::min<std::size_t>(16, most)}};
    const NeighbourTuning passes{1, 100, 7, 4, std::min<std::size_t>(8, most)};
    NeighbourTuning tickets = passes;
    tickets.tickets = true;
    return {own, passes, tickets};
}

void check_points(Outcome& outcome, Place& place, const Points& points, const std::string& what, bool both,
                  float radius = 3) {
    const Neighbours expected = by_tree(points, radius);
    for (const NeighbourTuning& tuning : tunings(place, both)) {
        const Neighbours found = opencl_neighbours(place.session(), points.x, points.y, radius, tuning);
        add(outcome.tally, flat(expected), flat(found),
            fmt::format("lists of {} points, {}, {} chunks{}", points.size(), what, tuning.chunks,
                        tuning.tickets ? " or tickets" : ""));
    }
}

Outcome few_points(Place& place, std::uint64_t seed) {
    Outcome outcome;
    for (const std::size_t count : telling_counts(place)) {
        if (!place.full() && count % 16 == 15) continue;  // as one more than a group, nearly
        for (const double side : {2.0, 9.0, 60.0}) {
            if (side < 3 && count > 300) continue;                     // all of them neighbours of all
            if (!place.full() && side < 10 && count > 2000) continue;  // half of them
            const Points points = crowd(count, side, static_cast<std::uint32_t>(seed + count));
            const bool both = place.full() || side == 9;
            check_points(outcome, place, points, fmt::format("in a square of {}", side), both);
        }
    }
    conclude(outcome);
    return outcome;
}

Outcome special_points(Place& place) {
    Outcome outcome;
    const bool both = !place.small();
    check_points(outcome, place, square_at_radius(12), "exactly at the radius", both);
    check_points(outcome, place, square_at_radius(12), "just within the radius", both, 3.0001f);
    check_points(outcome, place, line(place.small() ? 70 : 300), "on a line", both);
    // Far more widths of a bin along one axis than there are bins, and one along the other.
    check_points(outcome, place, pairs_apart(60, 1e5, 0), "in pairs along a row", both);
    check_points(outcome, place, pairs_apart(60, 0, 1e5), "in pairs along a column", both);
    check_points(outcome, place, moved(jittered(place.small() ? 60 : 500, 3), 1e5, -2e5), "far away", both);
    Points together;
    for (int i = 0; i < 40; ++i) together.add(1.5, -2.5);
    check_points(outcome, place, together, "at one place", both);
    conclude(outcome);
    return outcome;
}

Outcome many_points(Place& place, std::uint64_t seed) {
    Outcome outcome;
    if (place.small()) return {Verdict::skipped, {}, "left out with --small", {}};
    const auto draw = static_cast<std::uint32_t>(seed);
    for (const std::size_t count : {6000u, 70'001u}) {  // more than 16 bits count
        check_points(outcome, place, jittered(count, draw), "touching", true);
        check_points(outcome, place, line(count), "on a long line", true);
        if (count > 6000 && !place.full()) continue;
        check_points(outcome, place, clustered(count, draw), "in clusters", place.full());
        check_points(outcome, place, shuffled(uniform(count, draw), draw), "at random", place.full());
    }
    conclude(outcome);
    return outcome;
}

// A few points far out make the bins so wide that one of them holds all others, more than 16 bits count.
Outcome crowded_bin(Place& place, std::uint64_t seed) {
    if (place.small()) return {Verdict::skipped, {}, "left out with --small", {}};
    if (place.loop_limit() != 0) {
        return {Verdict::skipped, {}, fmt::format("the device ends loops after {} turns", place.loop_limit()), {}};
    }
    Points points = crowd(66'000, 1500, static_cast<std::uint32_t>(seed));
    points.add(4e6, 4e6);
    points.add(-4e6, -4e6);
    Outcome outcome;
    check_points(outcome, place, points, "nearly all in one bin", false);
    conclude(outcome);
    return outcome;
}

}  // namespace

std::vector<Check> neighbour_checks(std::uint64_t seed) {
    return {
        {"neighbours/few", "neighbour search", true, [=](Place& place) { return few_points(place, seed); }},
        {"neighbours/special", "neighbour search", true, special_points},
        {"neighbours/many", "neighbour search", true, [=](Place& place) { return many_points(place, seed); }},
        {"neighbours/crowded-bin", "neighbour search", false, [=](Place& place) { return crowded_bin(place, seed); }}};
}

}  // namespace pelage::verify
