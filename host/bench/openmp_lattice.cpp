// See openmp.hpp: lattices.
#include "bench/openmp.hpp"

#include "bench/aligned.hpp"
#include "bench/openmp_rows.hpp"
#include "bench/plane.hpp"
#include "bench/reaction_numbers.hpp"
#include "core/error.hpp"
#include "core/subnormal.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pelage::bench {

std::string why_no_openmp(const Case& one) {
#ifndef _OPENMP
    return one.name + ": this program was built without OpenMP";
#else
    constexpr std::array<std::string_view, 6> others{"cells", "neighbours", "aggregate", "volume", "mesh", "neural"};
    if (one.far_field) return "no far field was written by hand";
    if (one.kernel || std::ranges::find(others, one.suite) != others.end()) return {};
    return "there is no hand-written baseline for this case";
#endif
}

int openmp_threads() {
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

std::pair<std::size_t, std::size_t> own_share(std::size_t count) {
#ifdef _OPENMP
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const auto threads = static_cast<std::size_t>(omp_get_num_threads());
#else
    const std::size_t thread = 0, threads = 1;
#endif
    return {count * thread / threads, count * (thread + 1) / threads};
}

namespace {

struct FieldState {
    Plane now, next;
    float share, floor, limit;
};

class OpenmpLattice final : public Task {
public:
    OpenmpLattice(const Kernel& kernel, const Experiment& experiment, const Snapshot& initial)
        : turing_(kernel.model == model_named("turing")),
          kernel_(kernel),
          columns_(initial.columns),
          rows_(initial.rows) {
        const Phase& phase = experiment.phases.front();
        const SubnormalsAreZero scope;
        const auto dt = in_precision<float>(phase.time_step);
        for (std::size_t i = 0; i < 2; ++i) {
            const auto rate = in_precision<float>(initial.diff[i].front());
            fields_.push_back({Plane(columns_, rows_), Plane(columns_, rows_), (rate * dt) / 6.0f,
                               in_precision<float>(phase.bounds[i].floor), in_precision<float>(phase.bounds[i].limit)});
            start_[i].resize(initial.conc[i].size());
            std::ranges::transform(initial.conc[i], start_[i].begin(), in_precision<float>);
        }
        numbers_ = reaction_numbers(experiment);
        restart();
    }

    void restart() override {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t row = 0; row < rows_; ++row) {
                const std::span from = std::span(start_[i]).subspan(row * columns_, columns_);
                std::ranges::copy(from, fields_[i].now.row(row));
                close(fields_[i].now.row(row));
            }
        }
    }

    void work(std::uint64_t iterations) override {
#pragma omp parallel
        {
            const SubnormalsAreZero scope;
            const auto [begin, end] = own_share(rows_);
            Scratch scratch(columns_);
            for (std::uint64_t i = 0; i < iterations; ++i) {
                if (i % 2 == 0) {
                    step(begin, end, scratch, &FieldState::now, &FieldState::next);
                } else {
                    step(begin, end, scratch, &FieldState::next, &FieldState::now);
                }
#pragma omp barrier
            }
        }
        if (iterations % 2 == 0) return;
        for (FieldState& field : fields_) std::swap(field.now, field.next);
    }

    Outcome outcome() const override {
        Outcome found;
        for (std::size_t i = 0; i < 2; ++i) {
            std::vector<float> values;
            values.reserve(columns_ * rows_);
            for (std::size_t row = 0; row < rows_; ++row) {
                const float* from = fields_[i].now.row(row);
                values.insert(values.end(), from, from + columns_);
            }
            found.push_back(float_array("chemical " + std::to_string(i), values));
        }
        return found;
    }

    std::size_t bytes_held() const override { return 4 * fields_.front().now.bytes(); }

private:
    struct Scratch {  // sums of three rows of both fields
        explicit Scratch(std::size_t columns) : pitch((columns + 63) / 32 * 32), values(6 * pitch, 0.0f) {}
        float* at(std::size_t field, std::size_t i) { return values.data() + (3 * field + i) * pitch; }
        std::size_t pitch;
        Aligned<float> values;
    };

    std::size_t below(std::size_t row) const { return row > 0 ? row - 1 : kernel_.wrap ? rows_ - 1 : 0; }
    std::size_t above(std::size_t row) const { return row + 1 < rows_ ? row + 1 : kernel_.wrap ? 0 : row; }

    // The element beyond either end of a row.
    void close(float* row) const {
        row[-1] = row[kernel_.wrap ? columns_ - 1 : 0];
        row[columns_] = row[kernel_.wrap ? 0 : columns_ - 1];
    }

    void step(std::size_t begin, std::size_t end, Scratch& scratch, Plane FieldState::*from, Plane FieldState::*to) {
        const auto columns = static_cast<std::ptrdiff_t>(columns_);
        std::array<std::size_t, 3> turn{0, 1, 2};  // below, own, above
        if (begin < end) {
            for (std::size_t i = 0; i < 2; ++i) {
                sum_row((fields_[i].*from).row(below(begin)), scratch.at(i, 0), columns);
                sum_row((fields_[i].*from).row(begin), scratch.at(i, 1), columns);
            }
        }
        for (std::size_t row = begin; row < end; ++row) {
            std::array<FieldRow, 2> rows;
            for (std::size_t i = 0; i < 2; ++i) {
                FieldState& field = fields_[i];
                rows[i] = {(field.*from).row(row),
                           (field.*from).row(above(row)),
                           scratch.at(i, turn[0]),
                           scratch.at(i, turn[1]),
                           scratch.at(i, turn[2]),
                           (field.*to).row(row),
                           field.share,
                           field.floor,
                           field.limit};
            }
            if (turing_) {
                turing_row(rows[0], rows[1], numbers_, columns);
            } else {
                gray_scott_row(rows[0], rows[1], numbers_, columns);
            }
            for (const FieldRow& one : rows) close(one.next);
            std::rotate(turn.begin(), turn.begin() + 1, turn.end());
        }
    }

    bool turing_;  // else Gray-Scott
    Kernel kernel_;
    std::size_t columns_, rows_;
    std::vector<FieldState> fields_;
    std::array<std::vector<float>, 2> start_;
    ReactionNumbers numbers_;
};

}  // namespace

std::unique_ptr<Task> openmp_lattice(const Kernel& kernel, const Experiment& experiment, const Snapshot& initial) {
    return std::make_unique<OpenmpLattice>(kernel, experiment, initial);
}

}  // namespace pelage::bench
