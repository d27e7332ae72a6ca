// The approximate neighbour search of Malheiros & Walter on the device; the method is told at core's SpatialSorting.
#pragma once

#include "core/neighbours.hpp"
#include "opencl/device/session.hpp"
#include "opencl/neighbours/bins.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

class DeviceMatrix {
public:
    DeviceMatrix(const Session&, SpatialSorting);  // throws Error for a window that is not offered

    // Takes new positions, in order of id (cells are only ever added), and sorts. positions: a plane of x, then one
    // of y, each `pitch` long.
    void update(const cl::Buffer& positions, int pitch, int cells);
    void begin(const std::vector<cl_uint>& order);  // the next update goes on from it; empty: from that of ids

    // The lists of the latest update, by cell id. ids[i] == i. `longest` is not reset.
    void find(const cl::Buffer& ids, DeviceLists& lists);

    // The sets of the latest update, read from `lists`, against the exact ones.
    SearchStatistics statistics(const cl::Buffer& ids, const DeviceLists& lists) const;

    int cells() const { return cells_; }
    std::vector<cl_int> order() const;  // cell ids, row after row

private:
    void reserve(int places, int placed);  // and keeps the first `placed` ids
    bool sort_rounds(std::size_t rounds);
    Neighbours exact_sets() const;

    const Session& session_;
    int reach_;
    std::size_t rounds_;
    cl::Kernel load_, rows_, columns_, lists_;
    int cells_ = 0;
    int side_ = 0;
    std::size_t capacity_ = 0;  // places
    cl::Buffer x_, y_, cell_, moved_;
};

}  // namespace pelage
