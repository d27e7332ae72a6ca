// See tissue.hpp.
#include "opencl/aggregate/tissue.hpp"

#include "core/finite.hpp"
#include "opencl/aggregate/device.hpp"
#include "opencl/aggregate/far_device.hpp"
#include "opencl/device/cl_error.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace pelage {

namespace {

class OpenclAggregate final : public Tissue {
public:
    OpenclAggregate(std::shared_ptr<const Session> session, std::shared_ptr<const Experiment> shared,
                    const Snapshot& initial)
        : Tissue(std::move(shared), initial),
          session_(std::move(session)),
          aggregate_(aggregate_of(experiment())),
          state_(initial),
          device_(with_device(session_->info().name, [&] { return made(); })) {
        do_write(initial);
    }

    std::optional<ProgramCounts> programs() const override { return session_->program_counts(); }

private:
    std::unique_ptr<Grower> made() const {
        const bool sized = aggregate_.size.has_value();
        if (!aggregate_.far_field) return std::make_unique<DeviceAggregate>(session_, sized);
        return std::make_unique<DeviceFarAggregate>(session_, sized, far_grid(state_.columns, state_.rows));
    }

    std::size_t do_cells() const override { return state_.cells(); }

    void do_advance(std::uint64_t first, std::uint64_t count) override {
        while (count > 0) {
            const std::uint64_t some = std::min<std::uint64_t>(count, most_particles_at_once);
            const std::vector<Arrival> asked = arrivals(experiment(), first, some, state_);
            for (std::span<const Arrival> left = asked; !left.empty();) {
                const std::size_t at_once = std::min(device_->particles_at_once(front_), left.size());
                grow(left.first(at_once));
                left = left.subspan(at_once);
            }
            first += some;
            count -= some;
        }
    }

    void grow(std::span<const Arrival> asked) {
        std::vector<Particle> particles;
        for (const Arrival& arrival : asked) particles.push_back(arrival.particle);
        const auto sites = with_device(session_->info().name, [&] { return device_->grow(front_, particles); });
        for (std::size_t i = 0; i < sites.size(); ++i) {
            front_.take(sites[i], asked[i].particle.size);
            state_.birth[sites[i]] = static_cast<std::uint32_t>(asked[i].iteration);
        }
    }

    void do_set_rate(std::size_t chemical, double rate) override { std::ranges::fill(state_.diff[chemical], rate); }

    Snapshot do_read() const override {
        Snapshot shown = state_;
        const auto sums = with_device(session_->info().name, [&] { return device_->sums(front_); });
        show_aggregate(shown, aggregate_, front_, sums);
        return shown;
    }

    void do_write(const Snapshot& snapshot) override {
        state_ = snapshot;
        front_ = front_of(experiment(), snapshot);
        std::vector<std::int64_t> sums;  // those with a far field are always made anew
        if (!aggregate_.far_field) sums = told_sums(snapshot, aggregate_, front_);
        with_device(session_->info().name, [&] { device_->upload(front_, sums); });
    }

    std::optional<NonFinite> do_non_finite() const override { return first_non_finite(state_.conc); }

    std::shared_ptr<const Session> session_;
    const Aggregate& aggregate_;
    Snapshot state_;  // all but what front_ and the device know
    std::unique_ptr<Grower> device_;
    Front front_;
};

}  // namespace

std::unique_ptr<Tissue> make_opencl_aggregate(std::shared_ptr<const Session> session,
                                              std::shared_ptr<const Experiment> experiment, const Snapshot& initial) {
    if (session->options().fast) {  // a choice knows no nearly right: its arithmetic is not for a compiler to change
        OpenclOptions options = session->options();
        options.fast = false;
        session = std::make_shared<const Session>(session->info(), options);
    }
    return std::make_unique<OpenclAggregate>(std::move(session), std::move(experiment), initial);
}

}  // namespace pelage
