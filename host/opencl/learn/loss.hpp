// The loss of what has grown, and its slopes (kernels/learn/loss.cl, loss_lanes.cl).
#pragma once

#include "core/learning.hpp"
#include "opencl/device/session.hpp"

#include <array>
#include <cstddef>

namespace pelage {

class LearningJudge {
public:
    LearningJudge(const Session&, const LearningTask&);

    // Leaves the slopes along every number of `states` in `after`.
    LearningLoss<float> judge(const cl::Buffer& states, std::size_t set, const cl::Buffer& after);

private:
    void look(const cl::Buffer& states, std::size_t set);
    void compare(const cl::Buffer& states, std::size_t set);
    void go_back(const cl::Buffer& states, std::size_t set, const cl::Buffer& after);
    void rank();
    LearningLoss<float> losses() const;
    // Launches a kernel that takes a level's pixels, `many` of a row or a whole one each.
    void launch_rows(cl::Kernel&, std::size_t level, std::size_t many);

    const Session& session_;
    LearningShape shape_;
    bool shared_;
    std::size_t lists_;  // sorted numbers: one of each sample, level and direction
    double push_;
    cl::Kernel shrink_, look_, rank_, apart_, excess_, nearest_, along_, slopes_, begin_;
    cl::Buffer directions_, ranked_, shares_, factors_;  // given
    cl::Buffer pictures_, seen_, order_, aside_, sorted_, apart_numbers_, excess_numbers_, along_numbers_,
        picture_slopes_, losses_, rotations_;
};

}  // namespace pelage
