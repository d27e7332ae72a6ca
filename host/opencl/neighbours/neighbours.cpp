// See neighbours.hpp.
#include "opencl/neighbours/neighbours.hpp"

#include "core/error.hpp"
#include "core/experiment.hpp"
#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace pelage {

namespace {

constexpr std::size_t spare_places = 32;  // vectors read past the last point
constexpr int first_capacity = 32;        // entries a list

template <class T>
void upload(const Session& session, std::span<const double> x, std::span<const double> y, std::size_t pitch,
            const cl::Buffer& positions) {
    std::vector<T> planes(2 * pitch, T(0));
    std::ranges::transform(x, planes.begin(), [](double value) { return in_precision<T>(value); });
    std::ranges::transform(y, planes.begin() + static_cast<std::ptrdiff_t>(pitch),
                           [](double value) { return in_precision<T>(value); });
    session.queue().enqueueWriteBuffer(positions, CL_TRUE, 0, planes.size() * sizeof(T), planes.data());
}

std::vector<cl_int> download(const Session& session, const cl::Buffer& buffer, std::size_t count) {
    std::vector<cl_int> values(count);
    session.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(cl_int), values.data());
    return values;
}

// Finds the lists again and again until none is cut off.
void find(const Session& session, NeighbourBins& bins, const cl::Buffer& sorted, int pitch, int points, double radius,
          DeviceLists& lists) {
    const cl_int none = 0;
    for (int capacity = first_capacity;;) {
        lists.reserve(session, static_cast<std::size_t>(points), capacity);
        session.queue().enqueueFillBuffer(lists.longest, none, 0, sizeof none);
        bins.find(sorted, pitch, bins.order(), points, radius, lists);
        const int longest = download(session, lists.longest, 1).front();
        if (longest <= lists.capacity) return;
        capacity = longest;
    }
}

}  // namespace

Neighbours read_lists(const Session& session, const cl::Buffer& ids, const DeviceLists& lists, std::size_t points) {
    const std::vector<cl_int> order = download(session, ids, points);
    const std::vector<cl_int> lengths = download(session, lists.lengths, points);
    const auto capacity = static_cast<std::size_t>(lists.capacity);
    const std::vector<cl_int> entries = download(session, lists.entries, (points + 15) / 16 * 16 * capacity);
    Neighbours found;
    found.first.assign(points + 1, 0);
    for (std::size_t place = 0; place < points; ++place) {
        found.first[static_cast<std::size_t>(order[place]) + 1] = static_cast<std::size_t>(lengths[place]);
    }
    for (std::size_t i = 0; i < points; ++i) found.first[i + 1] += found.first[i];
    found.ids.resize(found.first.back());
    for (std::size_t place = 0; place < points; ++place) {
        std::uint32_t* row = found.ids.data() + found.first[static_cast<std::size_t>(order[place])];
        const cl_int* list = entries.data() + place / 16 * 16 * capacity + place % 16;
        for (std::size_t k = 0; k < static_cast<std::size_t>(lengths[place]); ++k) {
            row[k] = static_cast<std::uint32_t>(order[static_cast<std::size_t>(list[16 * k])]);
        }
    }
    return found;
}

Neighbours opencl_neighbours(const Session& session, std::span<const double> x, std::span<const double> y,
                             double radius, std::optional<NeighbourTuning> tuning) {
    if (x.size() != y.size()) throw Error(fmt::format("points have {} x but {} y", x.size(), y.size()));
    if (x.size() > largest_cell_count - spare_places) {
        throw Error(fmt::format("{} points; at most {} can be searched", x.size(), largest_cell_count - spare_places));
    }
    if (!(radius > 0)) throw Error(fmt::format("a search radius of {}; it must be positive", radius));
    if (x.empty()) return {{0}, {}};
    return with_device(session.info().name, [&] {
        const std::size_t pitch = x.size() + spare_places;
        const cl::Buffer positions = session.buffer(2 * pitch * session.scalar_bytes(), "positions");
        const cl::Buffer sorted = session.buffer(2 * pitch * session.scalar_bytes(), "sorted positions");
        if (session.is_double()) {
            upload<double>(session, x, y, pitch, positions);
        } else {
            upload<float>(session, x, y, pitch, positions);
        }
        session.queue().enqueueFillBuffer(sorted, cl_int{0}, 0, 2 * pitch * session.scalar_bytes());
        const int points = static_cast<int>(x.size());
        NeighbourBins bins(session, tuning.value_or(NeighbourTuning::of(session)));
        bins.sort(positions, static_cast<int>(pitch), points, radius);
        bins.gather(positions, static_cast<int>(pitch), points, sorted);
        DeviceLists lists;
        find(session, bins, sorted, static_cast<int>(pitch), points, radius, lists);
        return read_lists(session, bins.order(), lists, x.size());
    });
}

}  // namespace pelage
