// Slopes of weights, and the optimiser (kernels/learn/update.cl).
#pragma once

#include "core/learning.hpp"
#include "opencl/device/session.hpp"

#include <cstdint>

namespace pelage {

class WeightUpdate {
public:
    WeightUpdate(const Session&, const LearningShape&);  // all 0

    Learned<float> read() const;
    void write(const Learned<float>&);
    std::vector<float> slopes() const;
    const cl::Buffer& weights() const { return weights_; }

    void total(const cl::Buffer& sums);
    void adam(double rate, std::uint64_t count);

private:
    const Session& session_;
    LearningShape shape_;
    cl::Kernel total_, lengths_, adam_;
    cl::Buffer weights_, means_, squares_, slopes_, factors_, numbers_;
};

}  // namespace pelage
