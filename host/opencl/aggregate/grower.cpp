// See grower.hpp.
#include "opencl/aggregate/grower.hpp"

#include <algorithm>

namespace pelage {

cl_uint packed_site(std::uint32_t site, std::size_t columns) {
    if (site == no_site) return no_site;
    return static_cast<cl_uint>(site % columns | site / columns << 16);
}

std::uint32_t unpacked_site(cl_uint site, std::size_t columns) {
    return static_cast<std::uint32_t>((site >> 16) * columns + (site & 0x7fffu));
}

std::size_t growing_items(const Session& session, std::size_t most) {
    const std::size_t asked = session.options().work_group;
    const std::size_t wanted = asked != 0 ? asked : session.info().processor() ? 1 : 256;
    std::size_t items = 1;
    while (2 * items <= std::min({wanted, session.info().max_work_group, most})) items *= 2;
    return items;
}

bool groups_fit(const Session& session, std::span<const cl::Kernel> kernels, std::size_t items) {
    const auto fits = [&](const cl::Kernel& kernel) {
        return kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(session.device()) >= items;
    };
    return items == 1 || std::ranges::all_of(kernels, fits);
}

void fill(const Session& session, const cl::Buffer& to, const void* from, std::size_t bytes) {
    if (bytes > 0) session.queue().enqueueWriteBuffer(to, CL_TRUE, 0, bytes, from);
}

void enlarge(const Session& session, cl::Buffer& buffer, std::size_t bytes, const char* what) {
    cl::Buffer larger = session.buffer(bytes, what);
    if (buffer() != nullptr) {
        const std::size_t old = std::min(bytes, buffer.getInfo<CL_MEM_SIZE>());
        session.queue().enqueueCopyBuffer(buffer, larger, 0, 0, old);
        session.queue().finish();
    }
    buffer = larger;
}

}  // namespace pelage
