// Iterations of the system that learns, and the way back through them (kernels/learn/iteration.cl, reverse_lanes.cl).
#pragma once

#include "core/learning.hpp"
#include "opencl/device/session.hpp"

namespace pelage {

class LearnedIteration {
public:
    LearnedIteration(const Session&, const LearningShape&);

    void iterate(const cl::Buffer& weights, const cl::Buffer& from, const cl::Buffer& to);

    // Slopes along weights begin at 0 with this, and are added to by every step back.
    void begin_sums();
    void reverse(const cl::Buffer& weights, const cl::Buffer& state, const cl::Buffer& after, const cl::Buffer& before);
    const cl::Buffer& sums() const { return sums_; }  // [sample][run][weight][lane]

private:
    void reverse_lanes(const cl::Buffer& weights, const cl::Buffer& state, const cl::Buffer& after,
                       const cl::Buffer& before);

    const Session& session_;
    LearningShape shape_;
    std::size_t width_;
    bool shared_;
    cl::Kernel iterate_, reverse_, add_;  // the last one where work is shared
    cl::Buffer scratch_, slopes_, sums_;  // the second one, too
};

}  // namespace pelage
