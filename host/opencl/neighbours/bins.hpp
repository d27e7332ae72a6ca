// Sorting points into bins on the device, and the neighbour lists that follow from it.
#pragma once

#include "opencl/device/cl.hpp"
#include "opencl/device/session.hpp"
#include "opencl/neighbours/tickets.hpp"

#include <cstddef>
#include <optional>

namespace pelage {

// The shape of the work. It changes no result.
struct NeighbourTuning {
    std::size_t width = 16;     // 16: lists are found with vectors of 16 candidates; 1: one after the other
    std::size_t chunks = 1;     // most work-items of the sort
    std::size_t per_chunk = 1;  // points that are worth one more of them
    int bits = 0;               // of a key that one pass of the sort takes; 0: all, in one pass
    std::size_t group = 64;     // work-items in a group that find lists
    bool tickets = false;       // points take tickets of their bins, and are sorted only where a bin is crowded

    static NeighbourTuning of(const Session&);
};

// Neighbour lists of points in physical order; layout in kernels/common/list.cl.
struct DeviceLists {
    cl::Buffer lengths;  // int, one a point
    cl::Buffer entries;  // int, blocks of 16 points x capacity
    cl::Buffer longest;  // int, grows to the longest list that is cut off, being longer than `capacity`
    int capacity = 0;
    std::size_t points = 0;  // there is room for

    // Makes room. Contents are lost. Throws Error when the device has not that much memory.
    void reserve(const Session&, std::size_t at_least, int entries_each);
};

// radius * radius in the session's precision, rounded once.
double rounded_square(const Session&, double radius);

class NeighbourBins {
public:
    NeighbourBins(const Session&, NeighbourTuning);

    // Makes room for that many points. Throws Error when the device has not that much memory.
    void reserve(std::size_t points);

    // Sorts points by bin; `reach`: how far lists may look afterwards. positions: a plane of x, then one of y, each
    // `pitch` long.
    void sort(const cl::Buffer& positions, int pitch, int points, double reach);

    // order()[place] = which of the points given to sort() goes there.
    const cl::Buffer& order() const { return to_.order; }

    // positions in that order.
    void gather(const cl::Buffer& positions, int pitch, int points, const cl::Buffer& sorted);

    // Finds the lists of the points just sorted, now in that order: all others nearer than `radius`, strictly,
    // ascending by ids[place]. There must be 32 places
    // more than points in each plane. `longest` is not reset.
    void find(const cl::Buffer& positions, int pitch, const cl::Buffer& ids, int points, double radius,
              DeviceLists& lists);

private:
    bool sort_by_tickets(const cl::Buffer& positions, int pitch, int points, double reach);
    void find_bins(const cl::Buffer& positions, int pitch, int points, cl_int chunks, double reach);
    void lay_grid(cl_int boxes, double reach);
    void sort_pass(int points, cl_int chunks, bool first, int shift);

    const Session& session_;
    NeighbourTuning tuning_;
    cl::Kernel box_, grid_kernel_, keys_kernel_, count_, sum_, scan_, scatter_, starts_kernel_, gather_, lists_;
    std::size_t capacity_ = 0;  // points
    BinBuffers to_;
    cl::Buffer sorted_keys_, counts_, sums_, spare_order_;
    std::optional<TicketSort> tickets_;
};

}  // namespace pelage
