// The neighbour lists of free cells while they move.
#pragma once

#include "opencl/cells/options.hpp"
#include "opencl/cells/state.hpp"
#include "opencl/neighbours/bins.hpp"
#include "opencl/neighbours/spatial_sorting.hpp"

#include <optional>

namespace pelage {

class CellsLists {
public:
    // `service`: the program of cells/lists.cl. Throws Error for a negative skin and a window that is not offered.
    CellsLists(const Session&, const CellsOptions&, const cl::Program& service);

    // Brings the cells into the order of their bins and finds their lists; the approximate search leaves them where
    // they are.
    void build(CellsState&);

    // Makes room for the longest list and finds all again. False when there was room for it.
    bool lengthen(const CellsState&);

    void begin(const std::vector<cl_uint>& order);  // what spatial sorting goes on from: see Snapshot
    std::vector<cl_uint> order() const;

    const DeviceLists& lists() const { return lists_; }
    double longest_way() const;  // squared; lists hold while no cell moves farther
    double square() const { return rounded_square(session_, reach()); }  // of how far lists look

    // Of the latest build; empty where the search is exact.
    std::optional<SearchStatistics> statistics(const CellsState&) const;

private:
    void sort(CellsState&);
    void find(const CellsState&);
    double reach() const;

    const Session& session_;
    CellsOptions options_;
    NeighbourTuning tuning_;
    NeighbourBins bins_;
    std::optional<DeviceMatrix> matrix_;
    DeviceLists lists_;
    cl::Kernel move_;
};

}  // namespace pelage
