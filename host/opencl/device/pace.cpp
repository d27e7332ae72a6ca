// See pace.hpp.
#include "opencl/device/pace.hpp"

#include <utility>

namespace pelage {

void Pace::launched() {
    ++launches_;
    if (launches_ % wait_every == 0) {
        cl::Event now;
        session_.queue().enqueueMarkerWithWaitList(nullptr, &now);
        session_.queue().flush();
        if (milestone_() != nullptr) milestone_.wait();
        milestone_ = std::move(now);
    } else if (launches_ % flush_every == 0) {
        session_.queue().flush();
    }
}

}  // namespace pelage
