// Many iterations of a small tissue of free cells in one launch; see kernels/cells/together.cl.
#pragma once

#include "core/experiment.hpp"
#include "opencl/cells/lists.hpp"
#include "opencl/cells/mirror.hpp"
#include "opencl/cells/options.hpp"
#include "opencl/cells/programs.hpp"
#include "opencl/cells/state.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <cstdint>

namespace pelage {

// Whether one work-group shall carry out many iterations of that many cells: as the options have it, else where a
// device does better so. `grows`: some rule divides, so that lists would have to be found anew all the time.
bool cells_step_together(const DeviceInfo&, Path, const CellsOptions&, std::size_t cells, bool grows);

class CellsTogether {
public:
    explicit CellsTogether(const Session&);

    struct Way {
        std::size_t done = 0;      // iterations
        std::size_t cells = 0;     // children that found room included
        std::size_t children = 0;  // asked for in the last iteration; no room
        bool stale = false;        // all lists must be found anew
    };

    // Carries out iterations first .. first + most - 1, or fewer, from and to the arrays that hold the state. Lists
    // must hold for it.
    Way run(CellsStep&, const cl::Buffer& parameters, std::size_t width, CellsState&, const CellsLists&,
            const CellMirrors&, const Domain&, std::uint64_t first, std::uint64_t most);

private:
    std::size_t group() const;
    std::size_t longest_launch(std::size_t width, const CellsState&, const CellsLists&) const;

    const Session& session_;
    cl::Buffer marks_, sums_, report_;
    std::size_t marked_ = 0;  // cells that marks_ has room for
};

}  // namespace pelage
