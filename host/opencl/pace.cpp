// See pace.hpp.
#include "opencl/pace.hpp"

namespace pelage {

void Pace::launched() {
    ++launches_;
    if (launches_ % wait_every == 0) {
        const cl::Event before = milestone_;
        session_.queue().enqueueMarkerWithWaitList(nullptr, &milestone_);
        session_.queue().flush();
        if (before() != nullptr) before.wait();
    } else if (launches_ % flush_every == 0) {
        session_.queue().flush();
    }
}

}  // namespace pelage
