// One iteration of the system that learns, and the way back through it: from the slope of the loss along each number
// after the iteration to that along each number before it, and along each weight.
#pragma once

#include "core/learning.hpp"

#include <cstddef>
#include <vector>

namespace pelage::reference {

// y = x + c laplacian(x) + act(x W0 + b0) W1 of one sample, as a neural reaction with rate, diffusion and time step 1.
// x and y: [chemical][cell]. Every sum goes on with fma, in the order of the chemicals or hidden values.
template <class T>
void iterate(const LearningShape&, const std::vector<T>& weights, const T* x, T* y);

// Slopes along weights: partial sums, [sample][run of cells][lane][weight].
template <class T>
class WeightSums {
public:
    explicit WeightSums(const LearningShape& shape)
        : shape_(shape), lanes_(shape.batch * cell_runs * sum_lanes * shape.weights(), T(0)) {}

    T* of(std::size_t sample, std::size_t cell) {
        const std::size_t run = cell / shape_.run_cells();
        const std::size_t lane = (cell - run * shape_.run_cells()) % sum_lanes;
        return lanes_.data() + ((sample * cell_runs + run) * sum_lanes + lane) * shape_.weights();
    }
    std::vector<T> totals() const;

private:
    LearningShape shape_;
    std::vector<T> lanes_;
};

// after: slopes along y, replaced by those along x.
template <class T>
void reverse_iteration(const LearningShape&, const std::vector<T>& weights, const T* x, T* after, std::size_t sample,
                       WeightSums<T>&);

}  // namespace pelage::reference
