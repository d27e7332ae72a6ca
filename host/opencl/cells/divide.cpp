// See divide.hpp.
#include "opencl/cells/divide.hpp"

#include "core/error.hpp"
#include "opencl/device/launch.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

CellsDivision::CellsDivision(const Session& session, NeighbourTuning tuning, const cl::Program& service)
    : session_(session),
      tuning_(tuning),
      count_(service, "pelage_cells_count_children"),
      append_(service, "pelage_cells_append_children"),
      sums_(session.buffer(tuning.chunks * sizeof(cl_int), "sums of children")) {}

void CellsDivision::append(CellsState& state, const CellsWritten& written, std::uint64_t iteration,
                           std::size_t children) {
    const auto cells = static_cast<std::size_t>(state.cells());
    try {
        state.grow(cells + children);
    } catch (const Error& error) {
        throw Error(fmt::format("growth at iteration {}: {}", iteration, error.what()));
    }
    const std::size_t chunks = std::clamp<std::size_t>(cells / tuning_.per_chunk, 1, tuning_.chunks);
    const auto count = static_cast<cl_int>(chunks);
    Arguments(session_, count_).add(state.divides(), state.cells(), count, sums_);
    if (chunks > 1) launch(session_, count_, chunks);  // a single chunk needs no sums
    Arguments arguments(session_, append_);
    arguments.add(state.divides(), state.degrees(), state.cells(), state.pitch(), count, sums_, state.chemicals(),
                  state.mappings(), static_cast<cl_int>(iteration + 1), state.place_of());
    for (std::size_t i = 0; i < cell_array_count; ++i) {
        const auto array = static_cast<CellArray>(i);
        arguments.add(changes(written, array) ? state.spare(array) : state.now(array));
    }
    state.add_now(arguments);
    launch(session_, append_, chunks);
    state.append(children);
}

}  // namespace pelage
