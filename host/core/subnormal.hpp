// Subnormal numbers, those nearer to 0 than 2^-126: in single precision they are 0, wherever they would come in and
// wherever they would come out. Double precision keeps its own.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace pelage {

// `value` in the precision of a run. Every number that enters a run goes through here: states, parameters of rules,
// bounds, rates, time steps.
template <class T>
T in_precision(double value) {
    if constexpr (std::is_same_v<T, float>) {
        constexpr double smallest = 0x1p-126;
        if (std::fabs(value) < smallest) return std::signbit(value) ? -0.0f : 0.0f;
    }
    return static_cast<T>(value);
}

// While it lives, arithmetic of the calling thread takes subnormal numbers for 0 and gives 0 in place of them, of
// either sign. Where the processor has no such mode, or `wanted` is false, nothing changes. It holds for double too:
// `wanted` is for work in single precision alone.
class SubnormalsAreZero {
public:
    explicit SubnormalsAreZero(bool wanted = true);
    ~SubnormalsAreZero();
    SubnormalsAreZero(const SubnormalsAreZero&) = delete;
    SubnormalsAreZero& operator=(const SubnormalsAreZero&) = delete;

private:
    std::uint64_t before_ = 0;
    bool wanted_;
};

// Whether this processor has such a mode, found out by arithmetic.
bool processor_flushes();

}  // namespace pelage
