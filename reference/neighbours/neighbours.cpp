// See neighbours.hpp.
#include "reference/neighbours/neighbours.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// The library's header is not free of the warnings we ask for.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <nanoflann.hpp>
#pragma GCC diagnostic pop

namespace pelage {

namespace {

// Points with finite coordinates, in double: the tree's own rounding is then far below that of T.
struct Cloud {
    std::vector<double> x, y;
    std::vector<std::uint32_t> ids;

    std::size_t kdtree_get_point_count() const { return ids.size(); }
    double kdtree_get_pt(std::size_t point, std::size_t axis) const { return axis == 0 ? x[point] : y[point]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2, std::uint32_t>;

template <class T>
Cloud finite_points(std::span<const T> x, std::span<const T> y) {
    Cloud cloud;
    cloud.x.reserve(x.size());
    cloud.y.reserve(x.size());
    cloud.ids.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
        cloud.x.push_back(static_cast<double>(x[i]));
        cloud.y.push_back(static_cast<double>(y[i]));
        cloud.ids.push_back(static_cast<std::uint32_t>(i));
    }
    return cloud;
}

template <class T>
bool nearer(T x, T y, T other_x, T other_y, T square) {
    const T dx = other_x - x;
    const T dy = other_y - y;
    return dx * dx + dy * dy < square;
}

}  // namespace

template <class T>
Neighbours neighbours_exact(std::span<const T> x, std::span<const T> y, T radius) {
    if (x.size() != y.size()) throw Error(fmt::format("points have {} x but {} y", x.size(), y.size()));
    Neighbours found;
    found.first.assign(x.size() + 1, 0);
    const Cloud cloud = finite_points(x, y);
    if (cloud.ids.empty()) return found;
    const Tree tree(2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    // A little wider than T can round a distance; the test in T then decides.
    const double wide = static_cast<double>(radius) * (1 + 1e-5);
    const nanoflann::SearchParams unsorted(0, 0.0f, false);
    std::vector<std::pair<std::uint32_t, double>> near;
    found.ids.reserve(8 * x.size());
    for (std::size_t point = 0, i = 0; i < x.size(); ++i) {
        if (point < cloud.ids.size() && cloud.ids[point] == i) {
            const double centre[2] = {cloud.x[point], cloud.y[point]};
            tree.radiusSearch(centre, wide * wide, near, unsorted);
            const auto begin = static_cast<std::ptrdiff_t>(found.ids.size());
            for (const auto& match : near) {
                const std::uint32_t j = cloud.ids[match.first];
                if (j != i && nearer(x[i], y[i], x[j], y[j], radius * radius)) found.ids.push_back(j);
            }
            std::sort(found.ids.begin() + begin, found.ids.end());
            ++point;
        }
        found.first[i + 1] = found.ids.size();
    }
    return found;
}

template Neighbours neighbours_exact(std::span<const float>, std::span<const float>, float);
template Neighbours neighbours_exact(std::span<const double>, std::span<const double>, double);

namespace reference {

template <class T>
std::vector<std::uint32_t> NeighbourLists<T>::strayed(std::span<const T> x, std::span<const T> y) const {
    // 0.49 leaves room for the rounding of both tests. A place that is not finite never passes.
    const double allowed = 0.49 * static_cast<double>(skin_);
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i < x_.size()) {
            const double dx = static_cast<double>(x[i]) - static_cast<double>(x_[i]);
            const double dy = static_cast<double>(y[i]) - static_cast<double>(y_[i]);
            if (dx * dx + dy * dy < allowed * allowed) continue;
        }
        found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

// Every pair of which one has strayed is judged anew by the places now kept; the bound on later moves holds for these.
template <class T>
void NeighbourLists<T>::relist(const std::vector<std::uint32_t>& points) {
    const T square = (radius_ + skin_) * (radius_ + skin_);
    std::vector<std::uint8_t> anew(x_.size(), 0);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const std::uint32_t a : points) anew[a] = 1;
    for (const std::uint32_t a : points) {
        for (std::uint32_t b = 0; b < x_.size(); ++b) {
            if (b == a || !nearer(x_[a], y_[a], x_[b], y_[b], square)) continue;
            pairs.emplace_back(a, b);
            if (anew[b] == 0) pairs.emplace_back(b, a);
        }
    }
    std::ranges::sort(pairs);
    Neighbours joined;
    joined.first.reserve(x_.size() + 1);
    joined.ids.reserve(candidates_.ids.size() + pairs.size());
    joined.first.push_back(0);
    auto pair = pairs.begin();
    for (std::size_t point = 0; point < x_.size(); ++point) {
        const auto kept = anew[point] == 0 ? candidates_.of(point) : std::span<const std::uint32_t>();
        for (const std::uint32_t id : kept) {
            for (; pair != pairs.end() && pair->first == point && pair->second < id; ++pair) {
                joined.ids.push_back(pair->second);
            }
            if (anew[id] == 0) joined.ids.push_back(id);
        }
        for (; pair != pairs.end() && pair->first == point; ++pair) joined.ids.push_back(pair->second);
        joined.first.push_back(joined.ids.size());
    }
    candidates_ = std::move(joined);
}

template <class T>
void NeighbourLists<T>::update(std::span<const T> x, std::span<const T> y) {
    constexpr std::size_t few = 100;  // each is compared with all points
    if (x.size() < x_.size()) forget();
    const std::vector<std::uint32_t> points = strayed(x, y);
    if (points.empty()) return;
    x_.resize(x.size());
    y_.resize(x.size());
    if (points.size() > few || points.size() == x.size()) {
        x_.assign(x.begin(), x.end());
        y_.assign(y.begin(), y.end());
        candidates_ = neighbours_exact(x, y, radius_ + skin_);
        return;
    }
    for (const std::uint32_t point : points) {
        x_[point] = x[point];
        y_[point] = y[point];
    }
    relist(points);
}

template <class T>
void NeighbourLists<T>::forget() {
    candidates_ = {};
    x_.clear();
    y_.clear();
}

template class NeighbourLists<float>;
template class NeighbourLists<double>;

}  // namespace reference

}  // namespace pelage
