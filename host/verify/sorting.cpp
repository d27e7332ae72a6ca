// See sorting.hpp.
#include "verify/sorting.hpp"

#include "opencl/device/cl_error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"

#include <algorithm>
#include <bit>

namespace pelage::verify {

namespace {

// Work-items beyond the last chunk, if a group is not full, must do nothing.
constexpr std::size_t group = 3;

}  // namespace

struct DeviceSort::Buffers {
    int points = 0;
    cl::Buffer keys, sorted_keys, end, counts, sums, starts, order, spare_order;
};

DeviceSort::DeviceSort(const Session& session) : session_(session) {
    with_device(session.info().name, [&] {
        Source source;
        source.file("common/prelude.cl").file("common/scan.cl").file("common/sort.cl");
        const cl::Program program = session.build(source.str());
        count_ = cl::Kernel(program, "pelage_sort_count");
        sum_ = cl::Kernel(program, "pelage_sort_sum");
        scan_ = cl::Kernel(program, "pelage_sort_scan");
        scatter_ = cl::Kernel(program, "pelage_sort_scatter");
        starts_ = cl::Kernel(program, "pelage_sort_starts");
    });
}

void DeviceSort::pass(Buffers& at, const SortShape& shape, bool first, int shift) {
    const auto items = static_cast<std::size_t>(shape.chunks);
    const int scanners = shape.bits == 0 ? shape.chunks : std::min(256, 1 << shape.bits);
    pelage::Arguments(session_, count_).add(at.keys, at.points, shape.chunks, shape.bits, shift, at.end, at.counts);
    launch(session_, count_, items, group);
    pelage::Arguments(session_, sum_).add(at.counts, shape.chunks, shape.bits, at.end, scanners, at.sums);
    launch(session_, sum_, static_cast<std::size_t>(scanners), group);
    pelage::Arguments(session_, scan_)
        .add(at.counts, at.points, shape.chunks, shape.bits, at.end, scanners, at.sums, at.starts);
    launch(session_, scan_, static_cast<std::size_t>(scanners), group);
    if (!first) std::swap(at.order, at.spare_order);
    pelage::Arguments(session_, scatter_)
        .add(at.keys, first ? at.order : at.spare_order, first ? 1 : 0, at.points, shape.chunks, shape.bits, shift,
             at.end, at.counts, at.sorted_keys, at.order);
    launch(session_, scatter_, items, group);
}

Sorted DeviceSort::order(const std::vector<std::uint32_t>& keys, std::uint32_t end, const SortShape& shape) {
    return with_device(session_.info().name, [&] {
        const std::size_t digits = shape.bits == 0 ? end : std::size_t{1} << shape.bits;
        const std::size_t ints = keys.size() * sizeof(cl_int);
        const std::size_t most_starts = std::max<std::size_t>(digits, end) + 1;
        Buffers at;
        at.points = static_cast<int>(keys.size());
        at.keys = session_.buffer(ints, "keys");
        at.sorted_keys = session_.buffer(ints, "sorted keys");
        at.end = session_.buffer(sizeof(cl_int), "end of keys");
        at.counts = session_.buffer(static_cast<std::size_t>(shape.chunks) * digits * sizeof(cl_int), "counts of keys");
        at.sums = session_.buffer(std::max<std::size_t>(256, static_cast<std::size_t>(shape.chunks)) * sizeof(cl_int),
                                  "partial sums");
        at.starts = session_.buffer(most_starts * sizeof(cl_int), "starts of keys");
        at.order = session_.buffer(ints, "order");
        at.spare_order = session_.buffer(ints, "order");
        session_.queue().enqueueWriteBuffer(at.keys, CL_TRUE, 0, ints, keys.data());
        session_.queue().enqueueWriteBuffer(at.end, CL_TRUE, 0, sizeof end, &end);
        if (shape.bits == 0) {
            pass(at, shape, true, 0);
        } else {
            const int key_bits = static_cast<int>(std::bit_width(end));
            for (int shift = 0; shift < key_bits; shift += shape.bits) {
                pass(at, shape, shift == 0, shift);
                std::swap(at.keys, at.sorted_keys);
            }
            pelage::Arguments(session_, starts_).add(at.keys, at.points, at.end, at.starts);
            launch(session_, starts_, end, group);
        }
        Sorted sorted{std::vector<std::uint32_t>(keys.size()), std::vector<std::uint32_t>(end + 1)};
        session_.queue().enqueueReadBuffer(at.order, CL_TRUE, 0, ints, sorted.order.data());
        session_.queue().enqueueReadBuffer(at.starts, CL_TRUE, 0, (end + 1) * sizeof(cl_int), sorted.starts.data());
        return sorted;
    });
}

}  // namespace pelage::verify
