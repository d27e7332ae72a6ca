// Sorting points into bins on devices with thousands of small processors: see kernels/neighbours/tickets.cl.
#pragma once

#include "opencl/device/cl.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <string>

namespace pelage {

// What sorting into bins leaves behind, and what it works with.
struct BinBuffers {
    cl::Buffer boxes;   // scalar, four a group or chunk
    cl::Buffer grid;    // struct pelage_grid
    cl::Buffer bins;    // int: how many there are
    cl::Buffer keys;    // int, one a point: its bin
    cl::Buffer starts;  // int, one a bin and one more: the place of its first point
    cl::Buffer order;   // int: which point is at each place
    int most_bins = 0;
};

class TicketSort {
public:
    static constexpr std::size_t most_boxes = 64;  // groups that look for the box around all points

    // What stands before neighbours/tickets.cl in its program.
    static std::string settings(const Session&);

    TicketSort(const Session&, const cl::Program&);

    // Makes room. Throws Error when the device has not that much memory.
    void reserve(std::size_t points, std::size_t bins);

    // Fills `boxes` and says how many they are.
    int box(const cl::Buffer& positions, int pitch, int points, const cl::Buffer& boxes);

    // Fills `keys`, and unless a bin is crowded `starts` and `order`: false where one is.
    bool sort(const cl::Buffer& positions, int pitch, int points, const BinBuffers&);

private:
    void count(const cl::Buffer& positions, int pitch, int points, const BinBuffers&);
    bool crowded() const;

    const Session& session_;
    std::size_t team_;
    cl::Kernel box_, take_, sum_, scan_, starts_, redeem_, tidy_;
    cl::Buffer tickets_, counts_, sums_, fullest_;
};

}  // namespace pelage
