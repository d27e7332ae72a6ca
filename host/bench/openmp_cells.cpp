// See openmp.hpp: free cells.
#include "bench/aligned.hpp"
#include "bench/openmp.hpp"
#include "bench/openmp_rows.hpp"
#include "core/neighbours.hpp"
#include "core/subnormal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

namespace pelage::bench {

namespace {

constexpr float skin = 0.3f;
constexpr auto reach = static_cast<float>(interaction_range) + skin;
constexpr std::size_t lanes = 16;
constexpr float far_away = 1e15f;  // its square is still finite

enum Column : std::size_t { x, y, u, v, du, dv, column_count };
constexpr std::size_t stepped = 4;  // of them change

using Columns = std::array<Aligned<float>, column_count>;

class OpenmpCells final : public Task {
public:
    OpenmpCells(const Experiment& experiment, const Snapshot& initial) : cells_(initial.cells()) {
        const Phase& phase = experiment.phases.front();
        const React& react = std::get<React>(experiment.rules.front().action);
        numbers_.dt = in_precision<float>(phase.time_step);
        numbers_.scale = in_precision<float>(react.scale.value);
        numbers_.alpha = in_precision<float>(react.parameters[0].value);
        numbers_.beta = in_precision<float>(react.parameters[1].value);
        numbers_.half_width = in_precision<float>(experiment.domain.width / 2);
        numbers_.half_height = in_precision<float>(experiment.domain.height / 2);
        numbers_.floor_u = in_precision<float>(phase.bounds[0].floor);
        numbers_.limit_u = in_precision<float>(phase.bounds[0].limit);
        numbers_.floor_v = in_precision<float>(phase.bounds[1].floor);
        numbers_.limit_v = in_precision<float>(phase.bounds[1].limit);
        const std::array sources{&initial.x,       &initial.y,       &initial.conc[0],
                                 &initial.conc[1], &initial.diff[0], &initial.diff[1]};
        for (std::size_t i = 0; i < column_count; ++i) start_[i] = padded(*sources[i], i);
        neighbours_.resize(start_[x].size());
        restart();
    }

    void restart() override {
        now_ = start_;
        ids_.resize(cells_);
        std::iota(ids_.begin(), ids_.end(), 0);
        lists_valid_ = false;
    }

    void work(std::uint64_t iterations) override {
        for (std::uint64_t i = 0; i < iterations; ++i) {
            if (!lists_valid_) relist();
            lists_valid_ = step() < 0.49f * 0.49f * skin * skin;
            std::swap_ranges(now_.begin(), now_.begin() + stepped, next_.begin());
        }
    }

    Outcome outcome() const override {
        constexpr std::array names{"x", "y", "chemical 0", "chemical 1"};
        Outcome found;
        for (std::size_t i = 0; i < stepped; ++i) {
            std::vector<float> values(cells_);
            for (std::size_t place = 0; place < cells_; ++place) values[ids_[place]] = now_[i][place];
            found.push_back(float_array(names[i], values));
        }
        return found;
    }

    std::size_t bytes_held() const override {
        const std::size_t floats = (2 * column_count + 2) * now_[x].size();
        return 4 * (floats + entries_.size() + lengths_.size() + ids_.size() + neighbours_.size());
    }

private:
    std::size_t blocks() const { return (cells_ + lanes - 1) / lanes; }

    // Places up to a whole block, and one that is infinitely far from all and stands where a list has ended.
    Aligned<float> padded(const std::vector<double>& from, std::size_t column) const {
        Aligned<float> values(blocks() * lanes + lanes, column < 2 ? far_away : 0.0f);
        for (std::size_t i = 0; i < cells_; ++i) values[i] = in_precision<float>(from[i]);
        return values;
    }

    // The square of the farthest that a cell is now from where it was listed.
    float step() {
        CellArrays arrays;
        arrays.x = now_[x].data();
        arrays.y = now_[y].data();
        arrays.u = now_[u].data();
        arrays.v = now_[v].data();
        arrays.du = now_[du].data();
        arrays.dv = now_[dv].data();
        arrays.next_x = next_[x].data();
        arrays.next_y = next_[y].data();
        arrays.next_u = next_[u].data();
        arrays.next_v = next_[v].data();
        arrays.neighbours = neighbours_.data();
        float most = 0;
#pragma omp parallel firstprivate(arrays) reduction(max : most)
        {
            const SubnormalsAreZero scope;
#pragma omp for schedule(static)
            for (std::size_t block = 0; block < blocks(); ++block) {
                arrays.entries = entries_.data() + block * capacity_ * lanes;
                arrays.length = lengths_[block];
                const std::size_t begin = block * lanes;
                cell_block(arrays, numbers_, begin);
                most = std::max(most, farthest(arrays.next_x, arrays.next_y, listed_x_.data(), listed_y_.data(), begin,
                                               std::min(cells_, begin + lanes)));
            }
        }
        return most;
    }

    void relist();
    void sort_by_bins();
    bool fill_lists();
    std::size_t fill_list(std::size_t place);
    std::pair<std::size_t, std::size_t> bin_of(std::size_t place) const;

    std::size_t cells_;
    CellNumbers numbers_;
    Columns start_, now_, next_;      // by place
    std::vector<std::uint32_t> ids_;  // of the cell at each place
    std::vector<std::int32_t> neighbours_;
    bool lists_valid_ = false;
    std::size_t capacity_ = 12;           // entries a list
    std::vector<std::int32_t> entries_;   // blocks of 16 lists
    std::vector<std::int32_t> lengths_;   // of the longest list of each block
    Aligned<float> listed_x_, listed_y_;  // where each place was listed
    float low_x_ = 0, low_y_ = 0;         // corner of bin (0, 0)
    std::size_t bin_columns_ = 1, bin_rows_ = 1;
    std::vector<std::uint32_t> starts_;  // first place of each bin
};

std::pair<std::size_t, std::size_t> OpenmpCells::bin_of(std::size_t place) const {
    return {static_cast<std::size_t>((now_[x][place] - low_x_) / reach),
            static_cast<std::size_t>((now_[y][place] - low_y_) / reach)};
}

void OpenmpCells::sort_by_bins() {
    const auto [left, right] =
        std::minmax_element(now_[x].begin(), now_[x].begin() + static_cast<std::ptrdiff_t>(cells_));
    const auto [low, high] =
        std::minmax_element(now_[y].begin(), now_[y].begin() + static_cast<std::ptrdiff_t>(cells_));
    low_x_ = *left;
    low_y_ = *low;
    bin_columns_ = static_cast<std::size_t>((*right - *left) / reach) + 1;
    bin_rows_ = static_cast<std::size_t>((*high - *low) / reach) + 1;
    std::vector<std::uint32_t> keys(cells_);
    starts_.assign(bin_columns_ * bin_rows_ + 1, 0);
    for (std::size_t place = 0; place < cells_; ++place) {
        const auto [column, row] = bin_of(place);
        keys[place] = static_cast<std::uint32_t>(row * bin_columns_ + column);
        ++starts_[keys[place] + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::uint32_t> at(starts_.begin(), starts_.end() - 1);
    std::vector<std::uint32_t> ids(cells_);
    next_ = now_;
    for (std::size_t place = 0; place < cells_; ++place) {
        const std::uint32_t to = at[keys[place]]++;
        ids[to] = ids_[place];
        for (std::size_t i = 0; i < column_count; ++i) next_[i][to] = now_[i][place];
    }
    std::swap(now_, next_);
    std::swap(ids_, ids);
}

// The length, even where it is more than there is room for.
std::size_t OpenmpCells::fill_list(std::size_t place) {
    std::array<std::pair<std::uint32_t, std::int32_t>, 512> near;  // id and place
    std::size_t count = 0;
    const auto [column, row] = bin_of(place);
    const std::size_t first = column > 0 ? column - 1 : 0;
    const std::size_t last = std::min(column + 2, bin_columns_);
    for (std::size_t r = row > 0 ? row - 1 : 0; r < std::min(row + 2, bin_rows_); ++r) {
        const std::uint32_t end = starts_[r * bin_columns_ + last];
        for (std::uint32_t other = starts_[r * bin_columns_ + first]; other < end; ++other) {
            const float dx = now_[x][other] - now_[x][place];
            const float dy = now_[y][other] - now_[y][place];
            if (dx * dx + dy * dy < reach * reach && other != place && count < near.size()) {
                near[count++] = {ids_[other], static_cast<std::int32_t>(other)};
            }
        }
    }
    std::sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count));
    std::int32_t* list = entries_.data() + place / lanes * lanes * capacity_ + place % lanes;
    for (std::size_t k = 0; k < std::min(count, capacity_); ++k) list[k * lanes] = near[k].second;
    return count;
}

bool OpenmpCells::fill_lists() {
    const auto nobody = static_cast<std::int32_t>(blocks() * lanes);
    entries_.resize(blocks() * lanes * capacity_);
    lengths_.resize(blocks());
    std::size_t longest = 0;
#pragma omp parallel for schedule(static) reduction(max : longest)
    for (std::size_t block = 0; block < blocks(); ++block) {
        std::fill_n(entries_.begin() + static_cast<std::ptrdiff_t>(block * lanes * capacity_), lanes * capacity_,
                    nobody);
        std::size_t most = 0;
        for (std::size_t place = block * lanes; place < std::min(cells_, (block + 1) * lanes); ++place) {
            most = std::max(most, fill_list(place));
        }
        lengths_[block] = static_cast<std::int32_t>(most);
        longest = std::max(longest, most);
    }
    if (longest <= capacity_) return true;
    capacity_ = longest;
    return false;
}

void OpenmpCells::relist() {
    sort_by_bins();
    while (!fill_lists()) {
    }
    listed_x_ = now_[x];
    listed_y_ = now_[y];
}

}  // namespace

std::unique_ptr<Task> openmp_cells(const Experiment& experiment, const Snapshot& initial) {
    return std::make_unique<OpenmpCells>(experiment, initial);
}

}  // namespace pelage::bench
