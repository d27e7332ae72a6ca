// See openmp.hpp: volumes.
#include "bench/openmp.hpp"

#include "bench/openmp_rows.hpp"
#include "bench/plane.hpp"
#include "bench/reaction_numbers.hpp"
#include "core/space.hpp"
#include "core/subnormal.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pelage::bench {

namespace {

struct Parts {  // of one chemical
    Plane now, next;
    float share, floor, limit;
};

class OpenmpVolume final : public Task {
public:
    OpenmpVolume(const Experiment& experiment, const Snapshot& initial)
        : columns_(initial.columns), rows_(initial.rows), layers_(initial.layers) {
        const Phase& phase = experiment.phases.front();
        const SubnormalsAreZero scope;
        const auto dt = in_precision<float>(phase.time_step);
        for (std::size_t i = 0; i < 2; ++i) {
            const auto rate = in_precision<float>(initial.diff[i].front());
            parts_.push_back({Plane(columns_, rows_ * layers_), Plane(columns_, rows_ * layers_), rate * dt,
                              in_precision<float>(phase.bounds[i].floor), in_precision<float>(phase.bounds[i].limit)});
            start_[i].resize(initial.conc[i].size());
            std::ranges::transform(initial.conc[i], start_[i].begin(), in_precision<float>);
        }
        numbers_ = reaction_numbers(experiment);
        restart();
    }

    void restart() override {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t line = 0; line < rows_ * layers_; ++line) {
                float* row = parts_[i].now.row(line);
                std::copy_n(start_[i].data() + line * columns_, columns_, row);
                close(row);
            }
        }
    }

    void work(std::uint64_t iterations) override {
#pragma omp parallel
        {
            const SubnormalsAreZero scope;
            const auto [begin, end] = own_share(rows_ * layers_);
            for (std::uint64_t i = 0; i < iterations; ++i) {
                if (i % 2 == 0) {
                    step(begin, end, &Parts::now, &Parts::next);
                } else {
                    step(begin, end, &Parts::next, &Parts::now);
                }
#pragma omp barrier
            }
        }
        if (iterations % 2 == 0) return;
        for (Parts& part : parts_) std::swap(part.now, part.next);
    }

    Outcome outcome() const override {
        Outcome found;
        for (std::size_t i = 0; i < 2; ++i) {
            std::vector<float> values;
            values.reserve(columns_ * rows_ * layers_);
            for (std::size_t line = 0; line < rows_ * layers_; ++line) {
                const float* from = parts_[i].now.row(line);
                values.insert(values.end(), from, from + columns_);
            }
            found.push_back(float_array("chemical " + std::to_string(i), values));
        }
        return found;
    }

    std::size_t bytes_held() const override { return 4 * parts_.front().now.bytes(); }

private:
    // The elements beyond the ends of a row.
    void close(float* row) const {
        row[-1] = row[columns_ - 1];
        row[columns_] = row[0];
    }

    void step(std::size_t begin, std::size_t end, Plane Parts::*from, Plane Parts::*to) {
        const auto columns = static_cast<std::ptrdiff_t>(columns_);
        for (std::size_t line = begin; line < end; ++line) {
            const std::size_t row = line % rows_, layer = line / rows_;
            const auto at = [&](std::size_t r, std::size_t l) { return (l % layers_) * rows_ + r % rows_; };
            std::array<VolumeRow, 2> rows;
            for (std::size_t i = 0; i < 2; ++i) {
                const Plane& old = parts_[i].*from;
                rows[i] = {old.row(line),
                           old.row(at(row + rows_ - 1, layer)),
                           old.row(at(row + 1, layer)),
                           old.row(at(row, layer + layers_ - 1)),
                           old.row(at(row, layer + 1)),
                           (parts_[i].*to).row(line),
                           parts_[i].share,
                           parts_[i].floor,
                           parts_[i].limit};
            }
            gray_scott_volume_row(rows[0], rows[1], numbers_, columns);
            for (const VolumeRow& one : rows) close(one.next);
        }
    }

    std::size_t columns_, rows_, layers_;
    std::vector<Parts> parts_;
    std::array<std::vector<float>, 2> start_;
    ReactionNumbers numbers_;
};

}  // namespace

std::unique_ptr<Task> openmp_volume(const Experiment& experiment, const Snapshot& initial) {
    return std::make_unique<OpenmpVolume>(experiment, initial);
}

}  // namespace pelage::bench
