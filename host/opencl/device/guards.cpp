// See guards.hpp.
#include "opencl/device/guards.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

namespace {

std::size_t padded(std::size_t bytes) { return (bytes + sizeof poison - 1) / sizeof poison * sizeof poison; }

}  // namespace

Guards::Guards(cl::Context context, cl::CommandQueue queue, const cl::Device& device)
    : context_(std::move(context)), queue_(std::move(queue)) {
    // Sub-buffers begin at multiples of the device's alignment, which is given in bits.
    guard_ = std::max<std::size_t>(256, device.getInfo<CL_DEVICE_MEM_BASE_ADDR_ALIGN>() / 8);
}

cl::Buffer Guards::allocate(std::size_t bytes, const std::string& what, cl_mem_flags flags) {
    forget_released();
    const std::size_t size = guard_ + padded(bytes) + guard_;
    cl::Buffer whole(context_, flags, size);
    queue_.enqueueFillBuffer(whole, poison, 0, size);
    cl_buffer_region region{guard_, bytes};
    cl::Buffer inner = whole.createSubBuffer(flags, CL_BUFFER_CREATE_TYPE_REGION, &region);
    zones_.push_back({whole, inner, bytes, what});
    return inner;
}

// Buffers that nobody but this list holds any more.
void Guards::forget_released() {
    std::erase_if(zones_, [](const Zone& zone) { return zone.inner.getInfo<CL_MEM_REFERENCE_COUNT>() == 1; });
}

// All zones are fetched before one is waited for: many small waits would take most of a verification's time.
void Guards::check(const std::string& kernel) {
    const std::size_t words = guard_ / sizeof poison;
    std::vector<cl_uint> found(2 * words * zones_.size());
    cl_uint* to = found.data();
    for (const Zone& zone : zones_) {
        queue_.enqueueReadBuffer(zone.whole, CL_FALSE, 0, guard_, to);
        queue_.enqueueReadBuffer(zone.whole, CL_FALSE, guard_ + padded(zone.bytes), guard_, to + words);
        to += 2 * words;
    }
    queue_.finish();
    const cl_uint* from = found.data();
    for (const Zone& zone : zones_) {
        look({from, words}, false, zone, kernel);
        look({from + words, words}, true, zone, kernel);
        from += 2 * words;
    }
}

void Guards::look(std::span<const cl_uint> found, bool after, const Zone& zone, const std::string& kernel) const {
    const auto touched = [](cl_uint value) { return value != poison; };
    const auto written = std::ranges::count_if(found, touched);
    if (written == 0) return;
    const auto at = static_cast<std::size_t>(std::ranges::find_if(found, touched) - found.begin()) * sizeof poison;
    throw Error(fmt::format("kernel '{}' wrote {} outside the {}, which has {}: the first {} bytes {}", kernel,
                            counted(static_cast<std::uint64_t>(written), "word"), zone.what,
                            counted(zone.bytes, "byte"), after ? at : guard_ - at,
                            after ? "after its end" : "before its beginning"));
}

}  // namespace pelage
