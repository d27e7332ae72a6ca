// See openmp.hpp: networks.
#include "bench/openmp.hpp"

#include "bench/openmp_hidden.hpp"
#include "bench/plane.hpp"
#include "core/neural.hpp"
#include "core/subnormal.hpp"
#include "opencl/rules/network.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pelage::bench {

namespace {

using Fields = std::vector<Plane>;  // one of each chemical

class OpenmpNetwork final : public Task {
public:
    OpenmpNetwork(const Experiment& experiment, const Snapshot& initial)
        : columns_(initial.columns), rows_(initial.rows) {
        const auto& neural = std::get<Neural>(experiment.rules.front().action);
        const SubnormalsAreZero scope;
        dt_ = in_precision<float>(experiment.phases.front().time_step);
        const Network& network = *neural.network;
        for (const double weight : network_table(network)) weights_.push_back(in_precision<float>(weight));
        table_ = {network.chemicals, network.hidden, weights_.data()};
        for (std::size_t i = 0; i < network.chemicals; ++i) {
            shares_.push_back(dt_ * static_cast<float>(group_rate(i, network.chemicals)));
            now_.emplace_back(columns_, rows_);
            next_.emplace_back(columns_, rows_);
            start_.emplace_back(initial.conc[i].size());
            std::ranges::transform(initial.conc[i], start_.back().begin(), in_precision<float>);
        }
        restart();
    }

    void restart() override {
        for (std::size_t i = 0; i < now_.size(); ++i) {
            for (std::size_t row = 0; row < rows_; ++row) {
                std::copy_n(start_[i].data() + row * columns_, columns_, now_[i].row(row));
                close(now_[i].row(row));
            }
        }
    }

    void work(std::uint64_t iterations) override {
#pragma omp parallel
        {
            const SubnormalsAreZero scope;
            std::vector<float> flow(table_.chemicals * network_lanes);
            const auto [begin, end] = own_share(rows_);
            for (std::uint64_t i = 0; i < iterations; ++i) {
                const Fields& from = i % 2 == 0 ? now_ : next_;
                Fields& to = i % 2 == 0 ? next_ : now_;
                for (std::size_t row = begin; row < end; ++row) step(row, from, to, flow.data());
#pragma omp barrier
            }
        }
        if (iterations % 2 != 0) std::swap(now_, next_);
    }

    Outcome outcome() const override {
        Outcome found;
        for (std::size_t i = 0; i < now_.size(); ++i) {
            std::vector<float> values;
            for (std::size_t row = 0; row < rows_; ++row)
                values.insert(values.end(), now_[i].row(row), now_[i].row(row) + columns_);
            found.push_back(float_array("chemical " + std::to_string(i), values));
        }
        return found;
    }

    std::size_t bytes_held() const override {
        return 2 * now_.size() * now_.front().bytes() + weights_.size() * sizeof(float);
    }

private:
    // The elements beyond the ends of a row.
    void close(float* row) const {
        row[-1] = row[columns_ - 1];
        row[columns_] = row[0];
    }

    // 16 cells at a time; what lies beyond the last column is overwritten in the end.
    void step(std::size_t row, const Fields& from, Fields& to, float* flow) const {
        const std::size_t below = (row + rows_ - 1) % rows_, above = (row + 1) % rows_;
        std::array<const float*, largest_network_chemicals> x;
        for (std::size_t first = 0; first < columns_; first += network_lanes) {
            for (std::size_t i = 0; i < from.size(); ++i) x[i] = from[i].row(row) + first;
            ask_network(table_, x.data(), flow);
            for (std::size_t i = 0; i < from.size(); ++i)
                add_flow({from[i].row(below) + first, x[i], from[i].row(above) + first, shares_[i], dt_,
                          flow + i * network_lanes, to[i].row(row) + first});
        }
        for (std::size_t i = 0; i < to.size(); ++i) close(to[i].row(row));
    }

    std::size_t columns_, rows_;
    float dt_ = 0;
    std::vector<float> weights_, shares_;
    NetworkTable table_;
    Fields now_, next_;
    std::vector<std::vector<float>> start_;
};

}  // namespace

std::unique_ptr<Task> openmp_network(const Experiment& experiment, const Snapshot& initial) {
    return std::make_unique<OpenmpNetwork>(experiment, initial);
}

}  // namespace pelage::bench
