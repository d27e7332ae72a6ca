// See openmp.hpp: aggregates.
#include "bench/aligned.hpp"
#include "bench/openmp.hpp"
#include "bench/openmp_charges.hpp"
#include "core/aggregate.hpp"
#include "reference/aggregate/weight.hpp"

#include <algorithm>
#include <array>
#include <bit>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pelage::bench {

namespace {

constexpr std::size_t block = 256, most_new = 8;

std::size_t this_thread() {
#ifdef _OPENMP
    return static_cast<std::size_t>(omp_get_thread_num());
#else
    return 0;
#endif
}

struct alignas(128) Share {  // of one thread
    SumRange range;
    std::array<std::int64_t, most_new> added{};  // to the sums of new candidates
};

class OpenmpAggregate final : public Task {
public:
    OpenmpAggregate(const Experiment& experiment, const Snapshot& initial)
        : experiment_(experiment),
          aggregate_(aggregate_of(experiment_)),
          initial_(initial),
          start_(initial, aggregate_.order),
          shares_(static_cast<std::size_t>(openmp_threads())) {
        restart();
    }

    void restart() override {
        front_ = start_;
        iteration_ = initial_.iteration;
        charges_x_.clear();
        charges_y_.clear();
        for (const std::uint32_t charge : front_.charges()) add_charge_at(charge);
        x_.assign(front_.places().size(), -1);
        y_.assign(front_.places().size(), 0);
        sums_.assign(front_.places().size(), 0);
        blocks_.assign((sums_.size() + block - 1) / block, 0);
        range_ = {};
        for (std::size_t place = 0; place < sums_.size(); ++place) {
            const std::uint32_t site = front_.places()[place];
            if (site == no_site) continue;
            sums_[place] =
                sum_of_charges(charges_x_.data(), charges_y_.data(), charges_x_.size(), column(site), row(site));
            settle(place, sums_[place]);
        }
    }

    void work(std::uint64_t iterations) override {
        const std::vector<Arrival> asked = arrivals(experiment_, iteration_, iterations, initial_);
        iteration_ += iterations;
#pragma omp parallel
        for (const Arrival& one : asked) {
            const std::size_t thread = this_thread();
            weigh_share(thread, one.particle.eta);
#pragma omp barrier
#pragma omp single
            take(chosen(one.particle));
            add_share(thread);
#pragma omp barrier
#pragma omp single
            gather_shares();
        }
    }

    Outcome outcome() const override {
        Snapshot shown = initial_;
        show_aggregate(shown, aggregate_, front_, {sums_.begin(), sums_.end()});
        Outcome found;
        for (std::size_t i = 0; i < shown.conc.size(); ++i)
            found.push_back(float_array("chemical " + std::to_string(i), shown.conc[i]));
        return found;
    }

    std::size_t bytes_held() const override {
        return 16 * sums_.size() + 8 * (blocks_.size() + charges_x_.size()) + 4 * front_.sites().size();
    }

private:
    std::int32_t column(std::uint32_t site) const { return static_cast<std::int32_t>(site % front_.columns()); }
    std::int32_t row(std::uint32_t site) const { return static_cast<std::int32_t>(site / front_.columns()); }
    CandidateArrays candidates() { return {x_.data(), y_.data(), sums_.data()}; }

    void add_charge_at(std::uint32_t site) {
        charges_x_.push_back(column(site));
        charges_y_.push_back(row(site));
    }

    // From now on the candidate in a place counts.
    void settle(std::size_t place, std::int64_t sum) {
        const std::uint32_t site = front_.places()[place];
        sums_[place] = sum;
        x_[place] = column(site);
        y_[place] = row(site);
        range_.least = std::min(range_.least, sum);
        range_.most = std::max(range_.most, sum);
    }

    std::size_t begin_of(std::size_t thread, std::size_t count) const { return count * thread / shares_.size(); }

    WeightNumbers numbers(float eta) const {
        WeightNumbers made;
        const auto range = static_cast<std::uint64_t>(range_.most - range_.least);
        made.most = range_.most;
        made.down = std::max(0, static_cast<int>(std::bit_width(range)) - 31);
        made.scale = reference::reciprocal(static_cast<float>(static_cast<std::int32_t>(range >> made.down)));
        made.eta = eta;
        return made;
    }

    void weigh_share(std::size_t thread, float eta) {
        std::array<std::uint64_t, block> weights;
        const std::size_t end = begin_of(thread + 1, blocks_.size());
        for (std::size_t i = begin_of(thread, blocks_.size()); i < end; ++i)
            blocks_[i] =
                weigh(candidates(), i * block, std::min(sums_.size(), (i + 1) * block), numbers(eta), weights.data());
    }

    std::size_t chosen(const Particle& particle) {
        std::uint64_t total = 0, passed = 0;
        for (const std::uint64_t sum : blocks_) total += sum;
        const std::uint64_t drawn = reference::upper_product(particle.draw, total);
        std::size_t at = 0;
        while (passed + blocks_[at] <= drawn) passed += blocks_[at++];
        std::array<std::uint64_t, block> weights;
        weigh(candidates(), at * block, std::min(sums_.size(), (at + 1) * block), numbers(particle.eta),
              weights.data());
        std::size_t place = 0;
        while ((passed += weights[place]) <= drawn) ++place;
        return at * block + place;
    }

    void take(std::size_t place) {
        const std::uint32_t site = front_.places()[place];
        front_.take(site);
        add_charge_at(site);
        x_[place] = -1;
        x_.resize(front_.places().size(), -1);
        y_.resize(front_.places().size(), 0);
        sums_.resize(front_.places().size(), 0);
        blocks_.resize((sums_.size() + block - 1) / block);
    }

    void add_share(std::size_t thread) {
        Share& share = shares_[thread];
        const std::size_t charges = charges_x_.size(), from = begin_of(thread, charges);
        share.range = add_charge(candidates(), begin_of(thread, sums_.size()), begin_of(thread + 1, sums_.size()),
                                 charges_x_.back(), charges_y_.back());
        for (std::size_t i = 0; i < front_.added().size(); ++i) {
            const std::uint32_t site = front_.places()[front_.added()[i]];
            share.added[i] = sum_of_charges(charges_x_.data() + from, charges_y_.data() + from,
                                            begin_of(thread + 1, charges) - from, column(site), row(site));
        }
    }

    void gather_shares() {
        range_ = {};
        for (const Share& share : shares_) {
            range_.least = std::min(range_.least, share.range.least);
            range_.most = std::max(range_.most, share.range.most);
        }
        for (std::size_t i = 0; i < front_.added().size(); ++i) {
            std::int64_t sum = 0;
            for (const Share& share : shares_) sum += share.added[i];
            settle(front_.added()[i], sum);
        }
    }

    Experiment experiment_;
    const Aggregate& aggregate_;
    Snapshot initial_;
    Front start_, front_;
    std::uint64_t iteration_ = 0;
    Aligned<std::int32_t> x_, y_;  // of the candidate in each place; x: below 0 where there is none whose sum is known
    Aligned<std::int64_t> sums_;
    Aligned<std::int32_t> charges_x_, charges_y_;
    std::vector<std::uint64_t> blocks_;  // sums of weights
    std::vector<Share> shares_;
    SumRange range_;  // of all sums
};

}  // namespace

std::unique_ptr<Task> openmp_aggregate(const Experiment& experiment, const Snapshot& initial) {
    return std::make_unique<OpenmpAggregate>(experiment, initial);
}

}  // namespace pelage::bench
