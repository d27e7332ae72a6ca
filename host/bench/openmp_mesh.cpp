// See openmp.hpp: meshes.
#include "bench/openmp.hpp"

#include "bench/aligned.hpp"
#include "bench/openmp_rows.hpp"
#include "bench/reaction_numbers.hpp"
#include "core/space.hpp"
#include "core/subnormal.hpp"
#include "core/surface.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pelage::bench {

namespace {

constexpr std::size_t mesh_lanes = 16;

class OpenmpMesh final : public Task {
public:
    OpenmpMesh(const Experiment& experiment, const Snapshot& initial)
        : surface_(std::get<MeshCells>(space_of(experiment)).surface),
          blocks_((surface_->cells() + mesh_lanes - 1) / mesh_lanes) {
        const Phase& phase = experiment.phases.front();
        const SubnormalsAreZero scope;
        const auto dt = in_precision<float>(phase.time_step);
        for (std::size_t i = 0; i < 2; ++i) {
            now_[i].resize(blocks_ * mesh_lanes);
            next_[i].resize(blocks_ * mesh_lanes);
            floor_[i] = in_precision<float>(phase.bounds[i].floor);
            limit_[i] = in_precision<float>(phase.bounds[i].limit);
            start_[i].resize(initial.conc[i].size());
            std::ranges::transform(initial.conc[i], start_[i].begin(), in_precision<float>);
        }
        numbers_ = reaction_numbers(experiment);
        make_lists(
            {in_precision<float>(initial.diff[0].front()) * dt, in_precision<float>(initial.diff[1].front()) * dt});
        restart();
    }

    void restart() override {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t place = 0; place < surface_->cells(); ++place)
                now_[i][place] = start_[i][surface_->order[place]];
        }
    }

    void work(std::uint64_t iterations) override {
#pragma omp parallel
        {
            const SubnormalsAreZero scope;
            const auto [begin, end] = own_share(blocks_);
            for (std::uint64_t i = 0; i < iterations; ++i) {
                if (i % 2 == 0) {
                    step(begin, end, now_, next_);
                } else {
                    step(begin, end, next_, now_);
                }
#pragma omp barrier
            }
        }
        if (iterations % 2 != 0) std::swap(now_, next_);
    }

    Outcome outcome() const override {
        Outcome found;
        for (std::size_t axis = 0; axis < 2; ++axis)
            found.push_back(float_array(axis == 0 ? "x" : "y", coordinates(*surface_, axis)));
        for (std::size_t i = 0; i < 2; ++i) {
            std::vector<float> values(surface_->cells());
            for (std::size_t place = 0; place < values.size(); ++place) values[surface_->order[place]] = now_[i][place];
            found.push_back(float_array("chemical " + std::to_string(i), values));
        }
        return found;
    }

    std::size_t bytes_held() const override {
        return sizeof(float) * (4 * now_[0].size() + 3 * indices_.size()) + sizeof(std::size_t) * begins_.size();
    }

private:
    using Fields = std::array<Aligned<float>, 2>;

    // Neighbours in ascending id, as the reference takes them, but each by its place.
    void make_lists(const std::array<float, 2>& spread) {
        const Adjacency& adjacency = surface_->adjacency;
        std::vector<std::int32_t> place_of(surface_->cells());
        for (std::size_t place = 0; place < place_of.size(); ++place)
            place_of[surface_->order[place]] = static_cast<std::int32_t>(place);
        for (std::size_t block = 0; block < blocks_; ++block) {
            std::size_t longest = 0;
            for (std::size_t lane = 0; lane < mesh_lanes; ++lane)
                longest = std::max(longest, count(block * mesh_lanes + lane));
            for (std::size_t k = 0; k < longest; ++k) {
                for (std::size_t place = block * mesh_lanes; place < (block + 1) * mesh_lanes; ++place) {
                    const bool there = k < count(place);
                    const std::size_t entry = there ? adjacency.offsets[surface_->order[place]] + k : 0;
                    indices_.push_back(there ? place_of[adjacency.indices[entry]] : static_cast<std::int32_t>(place));
                    const float share = there ? static_cast<float>(adjacency.weights[entry]) : 0.0f;
                    for (std::size_t i = 0; i < 2; ++i) weights_[i].push_back(spread[i] * share);
                }
            }
            begins_.push_back(indices_.size());
        }
    }
    std::size_t count(std::size_t place) const {
        return place < surface_->cells() ? surface_->adjacency.count(surface_->order[place]) : 0;
    }

    void step(std::size_t begin, std::size_t end, const Fields& from, Fields& to) const {
        for (std::size_t block = begin; block < end; ++block) {
            const std::size_t first = begins_[block];
            MeshBlock part;
            part.u = from[0].data(), part.v = from[1].data();
            part.indices = indices_.data() + first;
            part.weights_u = weights_[0].data() + first, part.weights_v = weights_[1].data() + first;
            part.length = static_cast<std::int32_t>((begins_[block + 1] - first) / mesh_lanes);
            part.next_u = to[0].data(), part.next_v = to[1].data();
            part.floor_u = floor_[0], part.limit_u = limit_[0], part.floor_v = floor_[1], part.limit_v = limit_[1];
            turing_mesh_block(part, numbers_, block * mesh_lanes);
        }
    }

    std::shared_ptr<const MeshSurface> surface_;
    std::size_t blocks_;
    Fields now_, next_;
    std::array<float, 2> floor_{}, limit_{};
    std::array<std::vector<float>, 2> start_;
    std::vector<std::size_t> begins_{0};  // of each block's list
    Aligned<std::int32_t> indices_;
    std::array<Aligned<float>, 2> weights_;
    ReactionNumbers numbers_;
};

}  // namespace

std::unique_ptr<Task> openmp_mesh(const Experiment& experiment, const Snapshot& initial) {
    return std::make_unique<OpenmpMesh>(experiment, initial);
}

}  // namespace pelage::bench
