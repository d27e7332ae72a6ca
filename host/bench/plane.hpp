// Rows of a field for the C++ baselines of lattices and volumes.
#pragma once

#include "bench/aligned.hpp"

#include <cstddef>

namespace pelage::bench {

// The rows of one field, each with an element more at either end.
class Plane {
public:
    Plane(std::size_t columns, std::size_t rows)
        : pitch_(((columns + 2 * margin + 31) / 32 | 1) * 32),  // an odd multiple of 128 bytes: no 4K aliasing
          values_(pitch_ * rows, 0.0f) {}

    float* row(std::size_t row) { return values_.data() + row * pitch_ + margin; }
    const float* row(std::size_t row) const { return values_.data() + row * pitch_ + margin; }
    std::size_t bytes() const { return values_.size() * sizeof(float); }

private:
    static constexpr std::size_t margin = 16;
    std::size_t pitch_;
    Aligned<float> values_;
};

}  // namespace pelage::bench
