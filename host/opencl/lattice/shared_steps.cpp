// See shared_steps.hpp.
#include "opencl/lattice/shared_steps.hpp"

namespace pelage {

void SharedSteps::prepare(Arguments& arguments, std::size_t strips, std::size_t steps) {
    constexpr cl_int far = 1 << 30;
    if (strips != strips_ || levels_ > far || arrivals_ > far) {
        const std::size_t bytes = 32 * (1 + 2 * strips) * sizeof(cl_int);
        if (strips > strips_) flags_ = session_.buffer(bytes, "flags of shared steps");
        session_.queue().enqueueFillBuffer(flags_, cl_int{0}, 0, bytes);
        strips_ = strips;
        levels_ = 0;
        arrivals_ = 0;
    }
    const auto begin = levels_;
    levels_ += static_cast<cl_int>(steps);
    arrivals_ += static_cast<cl_int>(strips);
    arguments.add(flags_, strips, begin, arrivals_);
}

}  // namespace pelage
