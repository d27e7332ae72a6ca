// See points.hpp: the search on a device.
#include "bench/points.hpp"
#include "core/neighbours.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/neighbours/neighbours.hpp"

#include <algorithm>

namespace pelage::bench {

namespace {

constexpr std::size_t spare_places = 32;  // vectors read past the last point

class OpenclSearch final : public Task {
public:
    OpenclSearch(std::shared_ptr<const Session> session, const Points& points)
        : session_(std::move(session)),
          points_(static_cast<int>(points.x.size())),
          pitch_(points.x.size() + spare_places),
          bins_(*session_, NeighbourTuning::of(*session_)) {
        with_device(session_->info().name, [&] {
            std::vector<float> planes(2 * pitch_, 0.0f);
            std::ranges::transform(points.x, planes.begin(), [](double value) { return static_cast<float>(value); });
            std::ranges::transform(points.y, planes.begin() + static_cast<std::ptrdiff_t>(pitch_),
                                   [](double value) { return static_cast<float>(value); });
            const std::size_t bytes = planes.size() * sizeof(float);
            positions_ = session_->buffer(bytes, "positions");
            sorted_ = session_->buffer(bytes, "sorted positions");
            session_->queue().enqueueWriteBuffer(positions_, CL_TRUE, 0, bytes, planes.data());
            session_->queue().enqueueFillBuffer(sorted_, cl_int{0}, 0, bytes);
            fit_lists();
        });
    }

    void restart() override {}

    void work(std::uint64_t iterations) override {
        with_device(session_->info().name, [&] {
            for (std::uint64_t i = 0; i < iterations; ++i) search();
            session_->queue().finish();
        });
    }

    Outcome outcome() const override {
        return with_device(session_->info().name, [&] {
            const Neighbours found = read_lists(*session_, bins_.order(), lists_, static_cast<std::size_t>(points_));
            std::vector<std::uint32_t> lengths;
            for (std::size_t i = 0; i < found.cells(); ++i) {
                lengths.push_back(static_cast<std::uint32_t>(found.of(i).size()));
            }
            return Outcome{{"number of neighbours", lengths, false}, {"neighbours", found.ids, false}};
        });
    }

private:
    void search() {
        const int pitch = static_cast<int>(pitch_);
        bins_.sort(positions_, pitch, points_, interaction_range);
        bins_.gather(positions_, pitch, points_, sorted_);
        bins_.find(sorted_, pitch, bins_.order(), points_, interaction_range, lists_);
    }

    // Room for the longest list is found once, before anything is timed.
    void fit_lists() {
        for (int capacity = 32;;) {
            lists_.reserve(*session_, static_cast<std::size_t>(points_), capacity);
            session_->queue().enqueueFillBuffer(lists_.longest, cl_int{0}, 0, sizeof(cl_int));
            search();
            cl_int longest = 0;
            session_->queue().enqueueReadBuffer(lists_.longest, CL_TRUE, 0, sizeof longest, &longest);
            if (longest <= lists_.capacity) return;
            capacity = longest;
        }
    }

    std::shared_ptr<const Session> session_;
    int points_;
    std::size_t pitch_;
    NeighbourBins bins_;
    DeviceLists lists_;
    cl::Buffer positions_, sorted_;
};

}  // namespace

std::unique_ptr<Task> opencl_search(std::shared_ptr<const Session> session, const Points& points) {
    return std::make_unique<OpenclSearch>(std::move(session), points);
}

}  // namespace pelage::bench
