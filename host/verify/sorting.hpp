// The sort of kernels/common/sort.cl alone, driven as NeighbourBins does.
#pragma once

#include "opencl/device/session.hpp"

#include <cstdint>
#include <vector>

namespace pelage::verify {

struct SortShape {
    int chunks = 1;  // work-items
    int bits = 0;    // of a key that one pass takes; 0: all of it
};

struct Sorted {
    std::vector<std::uint32_t> order;   // order[place] = the key that goes there
    std::vector<std::uint32_t> starts;  // of each key's run, then the number of keys
};

class DeviceSort {
public:
    explicit DeviceSort(const Session&);

    // `end`: all keys are smaller.
    Sorted order(const std::vector<std::uint32_t>& keys, std::uint32_t end, const SortShape&);

private:
    struct Buffers;
    void pass(Buffers&, const SortShape&, bool first, int shift);

    const Session& session_;
    cl::Kernel count_, sum_, scan_, scatter_, starts_;
};

// Kernel pelage_tickets_tidy of kernels/neighbours/tickets.cl alone: bin b holds order[starts[b]] up to
// order[starts[b + 1]], which come out in ascending order. Tickets are drawn in whatever order work-items come, on
// processors mostly the ascending one.
std::vector<std::uint32_t> tidied_on_device(const Session&, const std::vector<std::uint32_t>& starts,
                                            const std::vector<std::uint32_t>& order);

}  // namespace pelage::verify
