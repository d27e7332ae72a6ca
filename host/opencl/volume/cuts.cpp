// See cuts.hpp.
#include "opencl/volume/cuts.hpp"

#include <algorithm>

namespace pelage {

namespace {

constexpr std::size_t few_rows = 32, many_rows = 64;
constexpr std::size_t shallow = 4;

std::vector<FusedShape> cuts_of(const DeviceInfo& device, const FusedShape& cut, const Volume& volume) {
    const std::size_t share = std::max<std::size_t>(1, volume.rows / std::max<std::size_t>(1, device.running_units()));
    const std::size_t deepest = std::min(cut.depth, volume.layers > 2 ? volume.layers - 2 : 1);  // see volume_shape()
    std::vector<FusedShape> found;
    const auto add = [&](std::size_t depth, std::size_t rows) {
        FusedShape one = cut;
        one.depth = std::min(depth, deepest);
        one.rows = std::min(rows, share);
        const auto same = [&](const FusedShape& other) { return other.depth == one.depth && other.rows == one.rows; };
        if (std::ranges::none_of(found, same)) found.push_back(one);
    };
    add(cut.depth, few_rows);
    add(shallow, few_rows);
    add(cut.depth, many_rows);
    add(cut.depth, share);
    return found;
}

}  // namespace

VolumeCuts::VolumeCuts(const DeviceInfo& device, const Choice& choice, const Volume& volume) {
    if (choice.path != Path::streamed || choice.cut.rows != 0) {
        candidates_.push_back({choice});
        return;
    }
    for (const FusedShape& cut : cuts_of(device, choice.cut, volume)) {
        candidates_.push_back({choice});
        candidates_.back().choice.cut = cut;
    }
}

const Choice& VolumeCuts::now() const { return candidates_[searching() ? timed_ % candidates_.size() : best_].choice; }

void VolumeCuts::took(double seconds_an_iteration) {
    Candidate& tried = candidates_[timed_ % candidates_.size()];
    tried.seconds = std::min(tried.seconds, seconds_an_iteration);
    ++timed_;
    const auto fastest = std::ranges::min_element(candidates_, {}, &Candidate::seconds);
    best_ = static_cast<std::size_t>(fastest - candidates_.begin());
}

}  // namespace pelage
