// See together.hpp.
#include "opencl/cells/together.hpp"

#include "opencl/device/launch.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace pelage {

namespace {

constexpr std::size_t most_strays = 64;                         // PELAGE_MOST_STRAYS
constexpr std::size_t most_chunks = 64;                         // PELAGE_MOST_CHUNKS
constexpr std::size_t updates_a_launch = std::size_t{1} << 22;  // of cells: some tenths of a second

}  // namespace

bool cells_step_together(const DeviceInfo& device, Path path, const CellsOptions& options, std::size_t cells,
                         bool grows) {
    if (options.approximate()) return false;
    if (options.together) return *options.together;
    if (path != Path::automatic) return path != Path::step;
    if (device.software_rasteriser()) return false;
    return cells <= (grows ? 2000u : 800u);
}

CellsTogether::CellsTogether(const Session& session)
    : session_(session),
      sums_(session.buffer(most_chunks * sizeof(cl_int), "sums of children")),
      report_(session.buffer(4 * sizeof(cl_int), "report of a launch")) {}

// On CPUs one thread takes all cells in vectors: work-items would only be loops around its own.
std::size_t CellsTogether::group() const {
    const std::size_t most = std::max<std::size_t>(1, session_.info().max_work_group);
    if (session_.options().work_group != 0) return std::min(session_.options().work_group, most);
    const bool vectors = session_.info().processor();
    return vectors ? 1 : std::min<std::size_t>(most, 256);
}

std::size_t CellsTogether::longest_launch(std::size_t width, const CellsState& state, const CellsLists& lists) const {
    const auto cells = static_cast<std::size_t>(state.room());
    if (!session_.info().software_rasteriser()) return std::max<std::size_t>(1, updates_a_launch / cells);
    const std::size_t each = (cells + group() * width - 1) / (group() * width);
    const auto capacity = static_cast<std::size_t>(lists.lists().capacity);
    const std::size_t turns = each * (capacity + most_strays + width * (cells / width + 16 * capacity));
    return std::max<std::size_t>(1, DeviceInfo::rasteriser_turns / turns);
}

CellsTogether::Way CellsTogether::run(CellsStep& step, const cl::Buffer& parameters, std::size_t width,
                                      CellsState& state, const CellsLists& lists, const CellMirrors& mirrors,
                                      const Domain& domain, std::uint64_t first, std::uint64_t most) {
    const auto pitch = static_cast<std::size_t>(state.pitch());
    if (marked_ != pitch) {
        marks_ = session_.buffer(pitch * sizeof(cl_int), "marks of strayed cells");
        session_.queue().enqueueFillBuffer(marks_, cl_int{0}, 0, pitch * sizeof(cl_int));
        marked_ = pitch;
    }
    const std::uint64_t count = std::min<std::uint64_t>(most, longest_launch(width, state, lists));
    Arguments arguments(session_, step.there);
    arguments.add(state.cells(), state.pitch(), state.room());
    for (const bool second : {false, true}) {
        for (std::size_t i = 0; i < cell_array_count; ++i) {
            const auto array = static_cast<CellArray>(i);
            arguments.add(second && changes(step.written, array) ? state.spare(array) : state.now(array));
        }
    }
    const DeviceLists& found = lists.lists();
    arguments.add(state.built(), found.lengths, found.entries, found.capacity, found.longest, Scalar{domain.width / 2},
                  Scalar{domain.height / 2}, Scalar{domain.packed ? domain.area : 0.0}, state.divides(),
                  state.degrees(), state.place_of(), Scalar{lists.longest_way()}, parameters, Scalar{lists.square()},
                  state.chemicals(), state.mappings(), mirrors.sorted(), mirrors.starts(), mirrors.rounds(), marks_,
                  sums_, report_, static_cast<cl_int>(count), static_cast<cl_uint>(first));
    launch(session_, step.there, group(), group());
    std::array<cl_int, 4> report{};
    session_.queue().enqueueReadBuffer(report_, CL_TRUE, 0, sizeof report, report.data());
    return {static_cast<std::size_t>(report[0]), static_cast<std::size_t>(report[1]),
            static_cast<std::size_t>(report[2]), report[3] != 0};
}

}  // namespace pelage
