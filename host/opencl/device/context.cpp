// See context.hpp.
#include "opencl/device/context.hpp"

#include <map>
#include <mutex>

namespace pelage {

namespace {

struct Known {
    std::mutex mutex;
    std::map<cl_device_id, std::weak_ptr<const cl::Context>> contexts;
};

Known& known() {
    static Known& all = *new Known;  // lives as long as the last session
    return all;
}

}  // namespace

std::shared_ptr<const cl::Context> shared_context(const cl::Device& device) {
    Known& all = known();
    const std::lock_guard lock(all.mutex);
    std::weak_ptr<const cl::Context>& place = all.contexts[device()];
    if (auto there = place.lock()) return there;
    auto context = std::make_shared<const cl::Context>(device);
    place = context;
    return context;
}

}  // namespace pelage
