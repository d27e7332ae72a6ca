// See spatial_sorting.hpp.
#include "opencl/neighbours/spatial_sorting.hpp"

#include "core/error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"
#include "opencl/neighbours/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace pelage {

namespace {

constexpr std::size_t rounds_at_once = 8;  // between two looks at whether anything moved
constexpr int band = 16;                   // columns a work-item
constexpr std::size_t group = 16;

int window_reach(std::size_t window) {
    for (int reach = 1; reach <= 5; ++reach) {
        if (window == static_cast<std::size_t>((2 * reach + 1) * (2 * reach + 1) - 1)) return reach;
    }
    throw Error(fmt::format("a spatial sorting window of {} places; allowed are 8, 24, 48, 80, 120", window));
}

int side_for(int cells) {
    int side = 0;
    while (static_cast<std::int64_t>(side) * side < cells) ++side;
    return side;
}

std::string matrix_source() {
    Source source;
    source.file("common/prelude.cl")
        .file("common/scan.cl")
        .file("common/list.cl")
        .file("neighbours/spatial_sorting.cl");
    return source.str();
}

}  // namespace

DeviceMatrix::DeviceMatrix(const Session& session, SpatialSorting settings)
    : session_(session), reach_(window_reach(settings.window)), rounds_(settings.rounds) {
    const cl::Program program = session.build(matrix_source());
    load_ = cl::Kernel(program, "pelage_matrix_load");
    rows_ = cl::Kernel(program, "pelage_matrix_rows");
    columns_ = cl::Kernel(program, "pelage_matrix_columns");
    lists_ = cl::Kernel(program, "pelage_matrix_lists");
    moved_ = session.buffer(rounds_at_once * sizeof(cl_int), "marks of a sort that goes on");
}

void DeviceMatrix::begin(const std::vector<cl_uint>& order) {
    cells_ = static_cast<int>(order.size());
    if (order.empty()) return;
    reserve(cells_, 0);
    session_.queue().enqueueWriteBuffer(cell_, CL_TRUE, 0, order.size() * sizeof(cl_uint), order.data());
}

void DeviceMatrix::reserve(int places, int placed) {
    if (static_cast<std::size_t>(places) <= capacity_) return;
    const std::size_t room = static_cast<std::size_t>(places) * 5 / 4;
    cl::Buffer larger = session_.buffer(room * sizeof(cl_int), "sorted cells");
    if (placed > 0) {
        session_.queue().enqueueCopyBuffer(cell_, larger, 0, 0, static_cast<std::size_t>(placed) * sizeof(cl_int));
    }
    cell_ = std::move(larger);
    x_ = session_.buffer(room * session_.scalar_bytes(), "sorted positions");
    y_ = session_.buffer(room * session_.scalar_bytes(), "sorted positions");
    capacity_ = room;
}

void DeviceMatrix::update(const cl::Buffer& positions, int pitch, int cells) {
    const int placed = cells < cells_ ? 0 : cells_;
    side_ = side_for(cells);
    const int places = side_ * side_;
    reserve(places, placed);
    cells_ = cells;
    Arguments(session_, load_).add(positions, pitch, placed, cells, places, x_, y_, cell_);
    launch(session_, load_, static_cast<std::size_t>(places), group);
    if (rounds_ != 0) {
        for (std::size_t left = rounds_; left > 0;) {
            const std::size_t now = std::min(left, rounds_at_once);
            if (!sort_rounds(now)) return;
            left -= now;
        }
        return;
    }
    // Every swap raises the sum of column * x + row * y over all places, so this ends.
    while (sort_rounds(rounds_at_once)) {
    }
}

// False when the last of these rounds found everything in order.
bool DeviceMatrix::sort_rounds(std::size_t rounds) {
    session_.queue().enqueueFillBuffer(moved_, cl_int{0}, 0, rounds_at_once * sizeof(cl_int));
    const auto side = static_cast<std::size_t>(side_);
    for (std::size_t round = 0; round < rounds; ++round) {
        Arguments(session_, rows_).add(x_, y_, cell_, side_, moved_, static_cast<cl_int>(round));
        launch(session_, rows_, side, 4);
        Arguments(session_, columns_).add(x_, y_, cell_, side_, band, moved_, static_cast<cl_int>(round));
        launch(session_, columns_, (side + band - 1) / band);
    }
    std::vector<cl_int> moved(rounds);
    session_.queue().enqueueReadBuffer(moved_, CL_TRUE, 0, rounds * sizeof(cl_int), moved.data());
    return moved.back() != 0;
}

void DeviceMatrix::find(const cl::Buffer& ids, DeviceLists& lists) {
    Arguments(session_, lists_)
        .add(x_, y_, cell_, cells_, side_, reach_, Scalar{interaction_range * interaction_range}, ids, lists.capacity,
             lists.lengths, lists.entries, lists.longest);
    launch(session_, lists_, (static_cast<std::size_t>(cells_) + 15) / 16 * 16, group);
}

std::vector<cl_int> DeviceMatrix::order() const {
    std::vector<cl_int> cell(static_cast<std::size_t>(cells_));
    if (!cell.empty()) session_.queue().enqueueReadBuffer(cell_, CL_TRUE, 0, cell.size() * sizeof(cl_int), cell.data());
    return cell;
}

SearchStatistics DeviceMatrix::statistics(const cl::Buffer& ids, const DeviceLists& lists) const {
    SearchStatistics statistics;
    statistics.iterations = 1;
    statistics.cells = static_cast<std::size_t>(cells_);
    if (cells_ == 0) return statistics;
    const Neighbours exact = exact_sets();
    const Neighbours found = read_lists(session_, ids, lists, statistics.cells);
    statistics.neighbours_exact = exact.ids.size();
    for (std::size_t cell = 0; cell < statistics.cells; ++cell) {
        std::vector<std::uint32_t> missed;
        std::ranges::set_difference(exact.of(cell), found.of(cell), std::back_inserter(missed));
        statistics.neighbours_missed += missed.size();
        statistics.cells_with_misses += missed.empty() ? 0 : 1;
        statistics.most_missed = std::max<std::uint64_t>(statistics.most_missed, missed.size());
    }
    return statistics;
}

// Of the positions as the latest update took them.
Neighbours DeviceMatrix::exact_sets() const {
    const std::vector<cl_int> cell = order();
    std::vector<double> x(cell.size());
    std::vector<double> y(cell.size());
    const auto scatter = [&]<class T>(T) {
        std::vector<T> plane(cell.size());
        session_.queue().enqueueReadBuffer(x_, CL_TRUE, 0, plane.size() * sizeof(T), plane.data());
        for (std::size_t i = 0; i < cell.size(); ++i)
            x[static_cast<std::size_t>(cell[i])] = static_cast<double>(plane[i]);
        session_.queue().enqueueReadBuffer(y_, CL_TRUE, 0, plane.size() * sizeof(T), plane.data());
        for (std::size_t i = 0; i < cell.size(); ++i)
            y[static_cast<std::size_t>(cell[i])] = static_cast<double>(plane[i]);
    };
    if (session_.is_double()) {
        scatter(double{});
    } else {
        scatter(float{});
    }
    return opencl_neighbours(session_, x, y);
}

}  // namespace pelage
