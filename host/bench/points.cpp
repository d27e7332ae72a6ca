// See points.hpp: points, and the searches of the host.
#include "bench/points.hpp"

#include "core/error.hpp"
#include "core/neighbours.hpp"
#include "reference/neighbours/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

// The library's header is not free of the warnings we ask for.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <nanoflann.hpp>
#pragma GCC diagnostic pop

namespace pelage::bench {

namespace {

constexpr auto radius = static_cast<float>(interaction_range);

double uniform(std::mt19937_64& generator, double low, double high) {  // the same on every machine
    return low + (high - low) * (static_cast<double>(generator() >> 11) * 0x1p-53);
}

Outcome sets_of(const std::vector<std::uint32_t>& lengths, std::vector<std::uint32_t> ids) {
    std::size_t at = 0;
    for (const std::uint32_t length : lengths) {
        const auto begin = ids.begin() + static_cast<std::ptrdiff_t>(at);
        std::sort(begin, begin + length);
        at += length;
    }
    return {{"number of neighbours", lengths, false}, {"neighbours", std::move(ids), false}};
}

struct Cloud {
    std::vector<float> x, y;
    std::size_t kdtree_get_point_count() const { return x.size(); }
    float kdtree_get_pt(std::size_t point, std::size_t axis) const { return axis == 0 ? x[point] : y[point]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 2, std::uint32_t>;

class NanoflannSearch final : public Task {
public:
    NanoflannSearch(const Points& points, bool all_threads)
        : cloud_{{points.x.begin(), points.x.end()}, {points.y.begin(), points.y.end()}},
          all_threads_(all_threads),
          lengths_(points.x.size()) {}

    void restart() override {}

    void work(std::uint64_t iterations) override {
        for (std::uint64_t i = 0; i < iterations; ++i) search();
    }

    Outcome outcome() const override {
        std::vector<std::uint32_t> ids;
        for (const std::vector<std::uint32_t>& part : parts_) ids.insert(ids.end(), part.begin(), part.end());
        return sets_of(lengths_, std::move(ids));
    }

private:
    static constexpr std::size_t part_size = 1024;  // points that one thread takes at a time

    void search() {
        const Tree tree(2, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(10));
        const std::size_t count = (cloud_.x.size() + part_size - 1) / part_size;
        parts_.resize(count);
#pragma omp parallel if (all_threads_)
        {
            std::vector<std::pair<std::uint32_t, float>> near;
#pragma omp for schedule(static)
            for (std::size_t part = 0; part < count; ++part) search_part(tree, part, near);
        }
    }

    void search_part(const Tree& tree, std::size_t part, std::vector<std::pair<std::uint32_t, float>>& near) {
        // A little wider, against rounding inside the tree; the strict test then decides.
        constexpr float wide = radius * radius * (1 + 1e-5f);
        const nanoflann::SearchParams unsorted(0, 0.0f, false);
        std::vector<std::uint32_t>& ids = parts_[part];
        ids.clear();
        for (std::size_t i = part * part_size; i < std::min(cloud_.x.size(), (part + 1) * part_size); ++i) {
            const float centre[2] = {cloud_.x[i], cloud_.y[i]};
            tree.radiusSearch(centre, wide, near, unsorted);
            const std::size_t before = ids.size();
            for (const auto& [id, distance] : near) {
                if (distance < radius * radius && id != i) ids.push_back(id);
            }
            lengths_[i] = static_cast<std::uint32_t>(ids.size() - before);
        }
    }

    Cloud cloud_;
    bool all_threads_;
    std::vector<std::uint32_t> lengths_;
    std::vector<std::vector<std::uint32_t>> parts_;  // ids, of part_size points each
};

class ReferenceSearch final : public Task {
public:
    explicit ReferenceSearch(const Points& points)
        : x_(points.x.begin(), points.x.end()), y_(points.y.begin(), points.y.end()) {}

    void restart() override {}
    void work(std::uint64_t iterations) override {
        for (std::uint64_t i = 0; i < iterations; ++i) found_ = neighbours_exact<float>(x_, y_, radius);
    }
    Outcome outcome() const override {
        std::vector<std::uint32_t> lengths;
        for (std::size_t i = 0; i < found_.cells(); ++i) {
            lengths.push_back(static_cast<std::uint32_t>(found_.of(i).size()));
        }
        return sets_of(lengths, found_.ids);
    }

private:
    std::vector<float> x_, y_;
    Neighbours found_;
};

}  // namespace

Points make_points(std::size_t count, bool shuffled) {
    std::mt19937_64 generator(1);
    const double side = std::sqrt(3.4641016 * static_cast<double>(count));
    const auto columns = std::max<std::size_t>(1, static_cast<std::size_t>(side / 2));
    Points points;
    const auto add = [&](double x, double y) {
        points.x.push_back(static_cast<double>(static_cast<float>(x)));
        points.y.push_back(static_cast<double>(static_cast<float>(y)));
    };
    for (std::size_t i = 0; i < count; ++i) {
        if (shuffled) {
            const double x = uniform(generator, -side / 2, side / 2);
            add(x, uniform(generator, -side / 2, side / 2));
            continue;
        }
        const std::size_t row = i / columns;
        const double x = -side / 2 + 2 * static_cast<double>(i % columns) + static_cast<double>(row % 2);
        const double y = -side / 2 + 1.7320508 * static_cast<double>(row);
        const double jitter = uniform(generator, -0.2, 0.2);
        add(x + jitter, y + uniform(generator, -0.2, 0.2));
    }
    return points;
}

std::unique_ptr<Task> nanoflann_search(const Points& points, bool all_threads) {
    return std::make_unique<NanoflannSearch>(points, all_threads);
}

std::unique_ptr<Task> reference_search(const Points& points) { return std::make_unique<ReferenceSearch>(points); }

}  // namespace pelage::bench
