// See shared_steps.hpp.
#include "opencl/shared_steps.hpp"

namespace pelage {

void SharedSteps::prepare(cl::Kernel& kernel, cl_uint place, std::size_t strips, std::size_t steps) {
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
    kernel.setArg(place, flags_);
    kernel.setArg(place + 1, static_cast<cl_int>(strips));
    kernel.setArg(place + 2, begin);
    kernel.setArg(place + 3, arrivals_);
}

}  // namespace pelage
