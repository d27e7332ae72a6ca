// See bins.hpp.
#include "opencl/neighbours/bins.hpp"

#include "core/error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace pelage {

namespace {

constexpr std::size_t grid_bytes = 64;  // struct pelage_grid, in either precision
constexpr std::size_t most_scanners = 256;

std::string neighbours_source(const Session& session, const NeighbourTuning& tuning) {
    Source source;
    source.text(fmt::format("#define PELAGE_WIDTH {}\n", tuning.width));
    for (const char* file : {"common/prelude.cl", "common/scan.cl", "common/sort.cl", "neighbours/bins.cl",
                             "common/list.cl", "neighbours/lists.cl"}) {
        source.file(file);
    }
    if (tuning.tickets) {
        source.text(TicketSort::settings(session));
        source.file("neighbours/tickets.cl");
    }
    return source.str();
}

}  // namespace

NeighbourTuning NeighbourTuning::of(const Session& session) {
    NeighbourTuning tuning;
    // rusticl on llvmpipe ends a work-item after 65,535 turns of its loops: many short chunks for it too.
    if (session.info().processor()) {
        tuning.chunks = std::clamp<std::size_t>(session.info().compute_units, 1, 32);
        tuning.per_chunk = 8192;
    } else {
        tuning.width = 1;
        tuning.chunks = 1024;
        tuning.per_chunk = 64;
        tuning.bits = 8;
        tuning.tickets = !session.info().software_rasteriser();
    }
    tuning.group = std::clamp<std::size_t>(session.info().max_work_group, 1, tuning.group);
    return tuning;
}

double rounded_square(const Session& session, double radius) {
    if (session.is_double()) return radius * radius;
    const auto rounded = static_cast<float>(radius);
    return static_cast<double>(rounded * rounded);
}

void DeviceLists::reserve(const Session& session, std::size_t at_least, int entries_each) {
    if (at_least <= points && entries_each <= capacity) return;
    const std::size_t wanted = std::max(at_least, points);
    const int wanted_capacity = std::max(entries_each, capacity);
    const std::size_t blocks = (wanted + 15) / 16;
    const auto most = static_cast<std::size_t>(std::numeric_limits<cl_int>::max());
    const std::size_t bytes = blocks * 16 * static_cast<std::size_t>(wanted_capacity) * sizeof(cl_int);
    if (bytes > session.info().max_allocation || blocks * 16 > most) {
        throw Error(fmt::format(
            "neighbour lists of {} cells with up to {} neighbours each need {} MiB; device '{}' "
            "allows {} MiB in one piece",
            wanted, wanted_capacity, bytes >> 20, session.info().name, session.info().max_allocation >> 20));
    }
    points = 0;  // until all is there again
    capacity = 0;
    entries = cl::Buffer();
    entries = session.buffer(bytes, "neighbour lists");
    lengths = session.buffer(blocks * 16 * sizeof(cl_int), "lengths of neighbour lists");
    if (longest() == nullptr) longest = session.buffer(sizeof(cl_int), "length of the longest neighbour list");
    points = blocks * 16;
    capacity = wanted_capacity;
}

NeighbourBins::NeighbourBins(const Session& session, NeighbourTuning tuning) : session_(session), tuning_(tuning) {
    const cl::Program program = session.build(neighbours_source(session, tuning));
    box_ = cl::Kernel(program, "pelage_bins_box");
    grid_kernel_ = cl::Kernel(program, "pelage_bins_grid");
    keys_kernel_ = cl::Kernel(program, "pelage_bins_keys");
    count_ = cl::Kernel(program, "pelage_sort_count");
    sum_ = cl::Kernel(program, "pelage_sort_sum");
    scan_ = cl::Kernel(program, "pelage_sort_scan");
    scatter_ = cl::Kernel(program, "pelage_sort_scatter");
    starts_kernel_ = cl::Kernel(program, "pelage_sort_starts");
    gather_ = cl::Kernel(program, "pelage_bins_gather");
    lists_ = cl::Kernel(program, "pelage_neighbours_lists");
    if (tuning.tickets) tickets_.emplace(session, program);
}

void NeighbourBins::reserve(std::size_t points) {
    if (points <= capacity_) return;
    // Twice as many bins as points: enough for tissue six times sparser than cells that touch; beyond, bins widen.
    const std::size_t bins = 2 * points + 1024;
    const std::size_t digits = tuning_.bits == 0 ? bins : std::size_t{1} << tuning_.bits;
    const std::size_t ints = points * sizeof(cl_int);
    to_.boxes = session_.buffer(std::max(tuning_.chunks, TicketSort::most_boxes) * 4 * session_.scalar_bytes(),
                                "bounding boxes");
    to_.grid = session_.buffer(grid_bytes, "grid of bins");
    to_.bins = session_.buffer(sizeof(cl_int), "number of bins");
    to_.keys = session_.buffer(ints, "bins of cells");
    to_.starts = session_.buffer((std::max(bins, digits) + 1) * sizeof(cl_int), "starts of bins");
    to_.order = session_.buffer(ints, "order of cells");
    sorted_keys_ = session_.buffer(ints, "sorted bins of cells");
    counts_ = session_.buffer(tuning_.chunks * digits * sizeof(cl_int), "counts of cells in bins");
    sums_ = session_.buffer(most_scanners * sizeof(cl_int), "partial sums");
    spare_order_ = session_.buffer(tuning_.bits == 0 ? 1 : ints, "order of cells");
    to_.most_bins = static_cast<int>(std::min<std::size_t>(bins, 0x7ffffff0));
    if (tickets_) tickets_->reserve(points, bins);
    capacity_ = points;
}

void NeighbourBins::sort(const cl::Buffer& positions, int pitch, int points, double reach) {
    reserve(static_cast<std::size_t>(points));
    const std::size_t wanted = std::max<std::size_t>(1, static_cast<std::size_t>(points) / tuning_.per_chunk);
    const auto chunks = static_cast<cl_int>(std::min(wanted, tuning_.chunks));
    if (tickets_ && sort_by_tickets(positions, pitch, points, reach)) return;
    if (!tickets_) find_bins(positions, pitch, points, chunks, reach);
    if (tuning_.bits == 0) {
        sort_pass(points, chunks, true, 0);
        return;
    }
    const auto key_bits = static_cast<int>(std::bit_width(static_cast<unsigned>(to_.most_bins)));
    for (int shift = 0; shift < key_bits; shift += tuning_.bits) {
        sort_pass(points, chunks, shift == 0, shift);
        std::swap(to_.keys, sorted_keys_);
    }
    Arguments(session_, starts_kernel_).add(to_.keys, points, to_.bins, to_.starts);
    launch(session_, starts_kernel_, std::min(static_cast<std::size_t>(to_.most_bins), std::size_t{1} << 16),
           tuning_.group);
}

// The bins of all points, and unless one is crowded the points in their order. A device that has no room for groups of
// that size goes without tickets from now on.
bool NeighbourBins::sort_by_tickets(const cl::Buffer& positions, int pitch, int points, double reach) {
    try {
        lay_grid(tickets_->box(positions, pitch, points, to_.boxes), reach);
        return tickets_->sort(positions, pitch, points, to_);
    } catch (const cl::Error& error) {
        if (error.err() != CL_INVALID_WORK_GROUP_SIZE) throw;
        tickets_.reset();
        return false;
    }
}

void NeighbourBins::find_bins(const cl::Buffer& positions, int pitch, int points, cl_int chunks, double reach) {
    const auto items = static_cast<std::size_t>(chunks);
    Arguments(session_, box_).add(positions, pitch, points, chunks, to_.boxes);
    launch(session_, box_, items);
    lay_grid(chunks, reach);
    Arguments(session_, keys_kernel_).add(positions, pitch, points, chunks, to_.grid, to_.keys);
    launch(session_, keys_kernel_, items);
}

void NeighbourBins::lay_grid(cl_int boxes, double reach) {
    Arguments(session_, grid_kernel_).add(to_.boxes, boxes, Scalar{reach}, to_.most_bins, to_.grid, to_.bins);
    launch(session_, grid_kernel_, 1);
}

// From to_.keys and to_.order to sorted_keys_ and to_.order.
void NeighbourBins::sort_pass(int points, cl_int chunks, bool first, int shift) {
    const auto items = static_cast<std::size_t>(chunks);
    const std::size_t scanners = tuning_.bits == 0 ? items : std::min(most_scanners, std::size_t{1} << tuning_.bits);
    Arguments(session_, count_).add(to_.keys, points, chunks, tuning_.bits, shift, to_.bins, counts_);
    launch(session_, count_, items);
    if (scanners > 1) {
        Arguments(session_, sum_).add(counts_, chunks, tuning_.bits, to_.bins, static_cast<cl_int>(scanners), sums_);
        launch(session_, sum_, scanners);
    }
    Arguments(session_, scan_)
        .add(counts_, points, chunks, tuning_.bits, to_.bins, static_cast<cl_int>(scanners), sums_, to_.starts);
    launch(session_, scan_, scanners);
    if (!first) std::swap(to_.order, spare_order_);
    Arguments(session_, scatter_)
        .add(to_.keys, first ? to_.order : spare_order_, first ? 1 : 0, points, chunks, tuning_.bits, shift, to_.bins,
             counts_, sorted_keys_, to_.order);
    launch(session_, scatter_, items);
}

void NeighbourBins::gather(const cl::Buffer& positions, int pitch, int points, const cl::Buffer& sorted) {
    Arguments(session_, gather_).add(to_.order, points, pitch, positions, sorted);
    launch(session_, gather_, static_cast<std::size_t>(points), tuning_.group);
}

void NeighbourBins::find(const cl::Buffer& positions, int pitch, const cl::Buffer& ids, int points, double radius,
                         DeviceLists& lists) {
    Arguments(session_, lists_)
        .add(positions, pitch, ids, to_.starts, points, to_.grid, Scalar{rounded_square(session_, radius)},
             lists.capacity, lists.lengths, lists.entries, lists.longest);
    const std::size_t items = (static_cast<std::size_t>(points) + 15) / 16 * 16;
    launch(session_, lists_, items, tuning_.group);
}

}  // namespace pelage
