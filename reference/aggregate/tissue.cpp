// See tissue.hpp.
#include "reference/aggregate/tissue.hpp"

#include "core/finite.hpp"
#include "reference/aggregate/far_growth.hpp"
#include "reference/aggregate/growth.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace pelage {

namespace {

class AggregateTissue final : public Tissue {
public:
    AggregateTissue(std::shared_ptr<const Experiment> shared, const Snapshot& initial)
        : Tissue(std::move(shared), initial), aggregate_(aggregate_of(experiment())) {
        do_write(initial);
    }

private:
    std::size_t do_cells() const override { return state_.cells(); }

    void do_advance(std::uint64_t first, std::uint64_t count) override {
        for (std::uint64_t iteration = first; iteration < first + count; ++iteration) {
            for (const Arrival& arrival : arrivals(experiment(), iteration, 1, state_)) {
                const auto site = std::visit([&](auto& growth) { return grow(growth, arrival.particle); }, growth_);
                if (!site) return;
                state_.birth[*site] = static_cast<std::uint32_t>(iteration);
            }
        }
    }

    template <class Growth>
    static std::optional<std::uint32_t> grow(Growth& growth, const Particle& particle) {
        const std::optional<std::uint32_t> site = growth.choose(particle);
        if (site) growth.take(*site, particle.size);
        return site;
    }

    void do_set_rate(std::size_t chemical, double rate) override { std::ranges::fill(state_.diff[chemical], rate); }

    Snapshot do_read() const override {
        Snapshot shown = state_;
        std::visit([&](const auto& growth) { show_aggregate(shown, aggregate_, growth.front(), growth.sums()); },
                   growth_);
        return shown;
    }

    void do_write(const Snapshot& snapshot) override {
        state_ = snapshot;
        Front front = front_of(experiment(), snapshot);
        if (aggregate_.far_field) {
            growth_ = reference::FarGrowth(std::move(front));
            return;
        }
        std::vector<std::int64_t> sums = told_sums(snapshot, aggregate_, front);
        growth_ = reference::Growth(std::move(front), std::move(sums));
    }

    std::optional<NonFinite> do_non_finite() const override { return first_non_finite(state_.conc); }

    const Aggregate& aggregate_;
    Snapshot state_;  // all but what growth_ knows
    std::variant<reference::Growth, reference::FarGrowth> growth_;
};

}  // namespace

std::unique_ptr<Tissue> make_reference_aggregate(std::shared_ptr<const Experiment> experiment,
                                                 const Snapshot& initial) {
    return std::make_unique<AggregateTissue>(std::move(experiment), initial);
}

}  // namespace pelage
