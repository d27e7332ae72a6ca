// See non_finite.hpp.
#include "opencl/cells/non_finite.hpp"

#include "core/error.hpp"
#include "core/finite.hpp"
#include "opencl/device/launch.hpp"

namespace pelage {

CellsNonFinite::CellsNonFinite(const Session& session, const cl::Program& service, std::size_t group)
    : session_(session),
      group_(group),
      kernel_(service, "pelage_cells_non_finite"),
      found_(session.buffer(sizeof(cl_int), "mark of a value that is not finite")) {}

std::optional<NonFinite> CellsNonFinite::first_in(const CellsState& state) {
    session_.queue().enqueueFillBuffer(found_, cl_int{0}, 0, sizeof(cl_int));
    Arguments(session_, kernel_)
        .add(state.now(CellArray::conc), state.cells(), state.pitch(), state.chemicals(), found_);
    launch(session_, kernel_, static_cast<std::size_t>(state.cells()), group_);
    cl_int found = 0;
    session_.queue().enqueueReadBuffer(found_, CL_TRUE, 0, sizeof found, &found);
    if (found == 0) return std::nullopt;
    const auto first = first_non_finite(state.download().conc);
    if (!first) throw Error("the device finds a value that is not finite where there is none");
    return first;
}

}  // namespace pelage
