// See lists.hpp.
#include "opencl/cells/lists.hpp"

#include "core/error.hpp"
#include "opencl/device/launch.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

namespace {

constexpr std::size_t cells_a_mover = 1024;

}  // namespace

CellsLists::CellsLists(const Session& session, const CellsOptions& options, const cl::Program& service)
    : session_(session),
      options_(options),
      tuning_(options.tuning.value_or(NeighbourTuning::of(session))),
      bins_(session, tuning_),
      move_(service, "pelage_cells_move") {
    if (!(options.skin >= 0)) throw Error(fmt::format("a skin of {}; it must not be negative", options.skin));
    if (options.approximate()) matrix_.emplace(session, options.sorting);
}

void CellsLists::begin(const std::vector<cl_uint>& order) {
    if (matrix_) matrix_->begin(order);
}

std::vector<cl_uint> CellsLists::order() const {
    if (!matrix_) return {};
    const std::vector<cl_int> cells = matrix_->order();
    return {cells.begin(), cells.end()};
}

// Wider than rounding can make a distance look shorter than it is.
double CellsLists::reach() const { return (interaction_range + options_.skin) * (1 + 1e-5); }

// Half of the skin for either cell, less what rounding may hide.
double CellsLists::longest_way() const { return options_.skin * options_.skin * 0.2495; }

void CellsLists::build(CellsState& state) {
    lists_.reserve(session_, static_cast<std::size_t>(state.pitch()), std::max(8, options_.list_capacity));
    if (matrix_) {
        matrix_->update(state.now(CellArray::position), state.pitch(), state.cells());
    } else {
        sort(state);
    }
    find(state);
}

void CellsLists::sort(CellsState& state) {
    bins_.reserve(static_cast<std::size_t>(state.pitch()));
    bins_.sort(state.now(CellArray::position), state.pitch(), state.cells(), reach());
    const auto cells = static_cast<std::size_t>(state.cells());
    const std::size_t most = tuning_.width > 1 ? tuning_.chunks : cells;
    const std::size_t movers = tuning_.width > 1 ? std::clamp<std::size_t>(cells / cells_a_mover, 1, most) : most;
    Arguments arguments(session_, move_);
    arguments.add(state.cells(), state.pitch(), static_cast<cl_int>(movers), state.chemicals(), state.mappings(),
                  bins_.order());
    state.add_now(arguments);
    state.add_spare(arguments);
    arguments.add(state.built(), state.place_of());
    launch(session_, move_, movers, tuning_.width > 1 ? 1 : tuning_.group);
    state.flip_all();
}

void CellsLists::find(const CellsState& state) {
    session_.queue().enqueueFillBuffer(lists_.longest, cl_int{0}, 0, sizeof(cl_int));
    const cl::Buffer& ids = state.now(CellArray::id);
    if (matrix_) {
        matrix_->find(ids, lists_);
    } else {
        bins_.find(state.now(CellArray::position), state.pitch(), ids, state.cells(), reach(), lists_);
    }
}

bool CellsLists::lengthen(const CellsState& state) {
    cl_int longest = 0;
    session_.queue().enqueueReadBuffer(lists_.longest, CL_TRUE, 0, sizeof longest, &longest);
    if (longest <= lists_.capacity) return false;
    const cl_int generous = longest > (1 << 30) ? longest : longest + longest / 4;
    lists_.reserve(session_, static_cast<std::size_t>(state.pitch()), (generous + 15) / 16 * 16);
    find(state);
    return true;
}

std::optional<SearchStatistics> CellsLists::statistics(const CellsState& state) const {
    if (!matrix_) return std::nullopt;
    return matrix_->statistics(state.now(CellArray::id), lists_);
}

}  // namespace pelage
