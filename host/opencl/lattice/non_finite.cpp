// See non_finite.hpp.
#include "opencl/lattice/non_finite.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"

#include <algorithm>
#include <vector>

namespace pelage {

namespace {

constexpr cl_uint no_cell = 0xffffffffu;

std::string source() { return Source().file("common/prelude.cl").file("lattice/non_finite.cl").str(); }

}  // namespace

LatticeNonFinite::LatticeNonFinite(const Session& session)
    : session_(session), kernel_(session.build(source()), "pelage_lattice_non_finite") {}

std::optional<NonFinite> LatticeNonFinite::first_in(const LatticeState& state) {
    const Grid& grid = state.grid();
    std::vector<cl_uint> found(state.conc().planes(), no_cell);
    const std::size_t bytes = found.size() * sizeof(cl_uint);
    if (found_() == nullptr) found_ = session_.buffer(bytes, "search results");
    session_.queue().enqueueWriteBuffer(found_, CL_TRUE, 0, bytes, found.data());
    Arguments(session_, kernel_).add(state.conc().now(), found_, grid.columns, grid.rows, grid.pitch(), found.size());
    const bool strips = session_.info().processor();
    const std::size_t items = strips ? std::min<std::size_t>(grid.rows, 8 * session_.info().compute_units) : grid.rows;
    session_.launch(kernel_, cl::NDRange(items, strips ? 1 : 64), cl::NDRange(1, 1));
    session_.queue().enqueueReadBuffer(found_, CL_TRUE, 0, bytes, found.data());
    const auto first = std::ranges::find_if(found, [](cl_uint cell) { return cell != no_cell; });
    if (first == found.end()) return std::nullopt;
    return NonFinite{static_cast<std::size_t>(first - found.begin()), *first};
}

}  // namespace pelage
