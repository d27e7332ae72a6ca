// What there is to try on each kind of device.
#include "opencl/lattice/choice.hpp"
#include "tune/candidate.hpp"

#include <algorithm>

namespace pelage::tune {

namespace {

using Candidates = std::vector<Candidate>;

void add(Candidates& list, const Candidate& candidate) {
    if (std::ranges::find(list, candidate) == list.end()) list.push_back(candidate);
}

Candidate streamed(std::size_t width, std::size_t depth, std::size_t columns, std::size_t rows) {
    return {Path::streamed, width, {depth, columns, rows, 0}};
}

Candidate tiled(std::size_t depth, std::size_t columns, std::size_t rows, std::size_t group) {
    return {Path::tiled, 0, {depth, columns, rows, group}};
}

Candidates for_processors(std::size_t width, Effort effort) {
    const std::size_t half = std::max<std::size_t>(1, width / 2);
    Candidates list{{},
                    streamed(width, 24, 256, 8),
                    streamed(width, 16, 512, 8),
                    {Path::shared, width, {}},
                    streamed(width, 32, 512, 4),
                    streamed(half, 16, 256, 8),
                    streamed(width, 16, 128, 16),
                    streamed(width, 8, 256, 8)};
    if (effort == Effort::quick) return list;
    for (const std::size_t across : {width, half}) {
        for (const std::size_t depth : {8u, 16u, 24u, 32u}) {
            for (const std::size_t columns : {128u, 256u, 384u, 512u}) {
                for (const std::size_t rows : {4u, 8u, 16u}) add(list, streamed(across, depth, columns, rows));
            }
        }
        add(list, {Path::shared, across, {}});
        add(list, {Path::step, across, {}});
    }
    return list;
}

Candidates for_others(Effort effort) {
    Candidates list{{},
                    tiled(6, 20, 20, 128),
                    tiled(6, 52, 32, 192),
                    tiled(4, 32, 32, 128),
                    {Path::step, 1, {0, 0, 0, 256}},
                    tiled(2, 52, 32, 256),
                    tiled(8, 20, 16, 128),
                    tiled(4, 52, 32, 256),
                    {Path::step, 2, {0, 0, 0, 128}},
                    {Path::streamed, 0, {8, 0, 0, 64}},
                    tiled(6, 52, 20, 256),
                    {Path::step, 4, {0, 0, 0, 64}}};
    if (effort == Effort::quick) return list;
    for (const std::size_t width : {1u, 2u, 4u}) {
        for (const std::size_t group : {32u, 64u, 128u, 256u}) add(list, {Path::step, width, {0, 0, 0, group}});
    }
    for (const std::size_t depth : {2u, 4u, 6u, 8u}) {
        for (const std::size_t columns : {20u, 32u, 52u}) {
            for (const std::size_t rows : {16u, 20u, 32u}) {
                for (const std::size_t group : {128u, 192u, 256u}) add(list, tiled(depth, columns, rows, group));
            }
        }
    }
    for (const std::size_t depth : {4u, 8u, 16u}) {
        for (const std::size_t group : {64u, 128u, 256u}) add(list, {Path::streamed, 0, {depth, 0, 0, group}});
    }
    return list;
}

}  // namespace

std::vector<Candidate> candidates(const DeviceInfo& device, Precision precision, Effort effort) {
    if (device.processor()) return for_processors(vector_lanes(device, precision), effort);
    Candidates list = for_others(effort);
    const std::size_t most = std::max<std::size_t>(1, device.max_work_group);
    std::erase_if(list, [&](const Candidate& candidate) { return candidate.cut.group > most; });
    return list;
}

}  // namespace pelage::tune
