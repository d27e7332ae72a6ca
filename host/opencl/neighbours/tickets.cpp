// See tickets.hpp.
#include "opencl/neighbours/tickets.hpp"

#include "opencl/device/launch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace pelage {

namespace {

constexpr std::size_t run = 8;             // bins that a work-item counts
constexpr cl_int most_of_a_bin = 64;       // points that one work-item may put in order
constexpr std::size_t points_a_box = 256;  // that are worth one more group

std::size_t groups_of(std::size_t bins, std::size_t team) { return (bins + team * run - 1) / (team * run); }

// Work-items of a group.
std::size_t team(const Session& session) {
    return std::bit_floor(std::clamp<std::size_t>(session.info().max_work_group, 1, 256));
}

}  // namespace

std::string TicketSort::settings(const Session& session) {
    return fmt::format("#define PELAGE_TEAM {}\n#define PELAGE_RUN {}\n#define PELAGE_MOST_OF_A_BIN {}\n",
                       team(session), run, most_of_a_bin);
}

TicketSort::TicketSort(const Session& session, const cl::Program& program)
    : session_(session),
      team_(team(session)),
      box_(program, "pelage_tickets_box"),
      take_(program, "pelage_tickets_take"),
      sum_(program, "pelage_tickets_sum"),
      scan_(program, "pelage_tickets_scan"),
      starts_(program, "pelage_tickets_starts"),
      redeem_(program, "pelage_tickets_redeem"),
      tidy_(program, "pelage_tickets_tidy") {}

void TicketSort::reserve(std::size_t points, std::size_t bins) {
    tickets_ = session_.buffer(points * sizeof(cl_int), "tickets of bins");
    counts_ = session_.buffer(bins * sizeof(cl_int), "counts of cells in bins");
    sums_ = session_.buffer(groups_of(bins, team_) * sizeof(cl_int), "partial sums");
    fullest_ = session_.buffer(sizeof(cl_int), "cells of the fullest bin");
}

int TicketSort::box(const cl::Buffer& positions, int pitch, int points, const cl::Buffer& boxes) {
    const std::size_t worth = (static_cast<std::size_t>(points) + points_a_box - 1) / points_a_box;
    const std::size_t groups = std::clamp<std::size_t>(worth, 1, most_boxes);
    Arguments(session_, box_).add(positions, pitch, points, boxes);
    launch(session_, box_, groups * team_, team_);
    return static_cast<int>(groups);
}

bool TicketSort::sort(const cl::Buffer& positions, int pitch, int points, const BinBuffers& to) {
    count(positions, pitch, points, to);
    if (crowded()) return false;
    const auto most_bins = static_cast<std::size_t>(to.most_bins);
    const std::size_t groups = groups_of(most_bins, team_);
    Arguments(session_, scan_).add(sums_, groups);
    launch(session_, scan_, team_, team_);
    Arguments(session_, starts_).add(counts_, to.most_bins, points, sums_, to.starts);
    launch(session_, starts_, groups * team_, team_);
    Arguments(session_, redeem_).add(to.keys, tickets_, points, to.starts, to.order);
    launch(session_, redeem_, static_cast<std::size_t>(points), team_);
    Arguments(session_, tidy_).add(to.starts, to.bins, to.order);
    launch(session_, tidy_, most_bins, team_);
    return true;
}

void TicketSort::count(const cl::Buffer& positions, int pitch, int points, const BinBuffers& to) {
    const auto most_bins = static_cast<std::size_t>(to.most_bins);
    session_.queue().enqueueFillBuffer(counts_, cl_int{0}, 0, most_bins * sizeof(cl_int));
    session_.queue().enqueueFillBuffer(fullest_, cl_int{0}, 0, sizeof(cl_int));
    Arguments(session_, take_).add(positions, pitch, points, to.grid, to.keys, tickets_, counts_);
    launch(session_, take_, static_cast<std::size_t>(points), team_);
    Arguments(session_, sum_).add(counts_, to.most_bins, sums_, fullest_);
    launch(session_, sum_, groups_of(most_bins, team_) * team_, team_);
}

bool TicketSort::crowded() const {
    cl_int fullest = 0;
    session_.queue().enqueueReadBuffer(fullest_, CL_TRUE, 0, sizeof fullest, &fullest);
    return fullest > most_of_a_bin;
}

}  // namespace pelage
