// See prepattern.hpp.
#include "core/prepattern.hpp"

#include "core/arrangements.hpp"
#include "core/error.hpp"
#include "core/published_random.hpp"
#include "core/seed.hpp"
#include "core/space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

struct Polarity {
    double x = 0.0;
    double y = 0.0;
};

// T is the precision of the run. What is drawn is drawn in float, as the published program does; what is written in the
// experiment keeps T.
template <class T>
class Builder {
public:
    explicit Builder(const Experiment& experiment)
        : experiment_(experiment), conc_(experiment.chemicals.size()), diff_(experiment.chemicals.size()) {
        state_.conc.resize(experiment.chemicals.size());
        state_.diff.resize(experiment.chemicals.size());
        reseed(1);
    }

    void operator()(const UseChemical& use) {
        if (use.conc) conc_[use.chemical] = *use.conc;
        if (use.diff) diff_[use.chemical] = *use.diff;
    }
    void operator()(const UsePolarity& use) { polarity_ = use.degrees; }
    void operator()(const UseSeed& use) { reseed(use.seed); }
    void operator()(const CreateCell& cell) { create(static_cast<T>(cell.x), static_cast<T>(cell.y), cell.fixed); }

    void operator()(const CreateGrid& grid) {
        const float dev = static_cast<float>(grid.deviation);
        reserve(state_.cells() + grid.columns * std::max<std::size_t>(grid.rows, 1));
        if (dev == 0.0f) return for_each_centre<T>(grid, [&](T x, T y) { create(x, y, grid.fixed); });
        for_each_centre<float>(grid, [&](float x, float y) {
            // The published program draws y first, and its jitter lies in [-2 dev, 0].
            const float jitter_y = random_.range(-dev - dev, -dev + dev);
            const float jitter_x = random_.range(-dev - dev, -dev + dev);
            create(T{x + jitter_x}, T{y + jitter_y}, grid.fixed);
        });
    }

    void operator()(const CreateMatrix& matrix) {
        (*this)(CreateGrid{Arrangement::sqr_grid, matrix.columns, matrix.rows, matrix.x, matrix.y, 0.0, false, false});
    }

    void operator()(const CreateShape& shape) {
        std::size_t columns = 0;
        for (const std::string& line : shape.lines) columns = std::max(columns, line.size());
        std::array<std::vector<std::uint32_t>, 26> upper, lower;
        for (std::size_t row = 0; row < shape.lines.size(); ++row) {
            const double up = static_cast<double>(shape.lines.size()) / 2.0 - static_cast<double>(row);
            const T y = static_cast<T>(static_cast<T>(shape.y) + up * 2);
            for (std::size_t column = 0; column < shape.lines[row].size(); ++column) {
                const auto letter = static_cast<unsigned char>(shape.lines[row][column]);
                if (std::isalpha(letter) == 0) continue;
                const double across = static_cast<double>(column) - static_cast<double>(columns) / 2.0;
                const auto id = static_cast<std::uint32_t>(state_.cells());
                create(static_cast<T>(static_cast<T>(shape.x) + across * 2), y, shape.fixed);
                if (letter == 'o' || letter == 'O') continue;
                if (std::isupper(letter) != 0)
                    upper[letter - 'A'].push_back(id);
                else
                    lower[letter - 'a'].push_back(id);
            }
        }
        for (std::size_t letter = 0; letter < 26; ++letter) pair_mirrors(upper[letter], lower[letter]);
    }

    void operator()(const SetCells& set) {
        if (set.last < set.first || set.last >= state_.cells()) {
            throw Error(fmt::format("{}: `set` names cells {} to {}; cells 0 to {} exist", experiment_.source,
                                    set.first, set.last, static_cast<std::int64_t>(state_.cells()) - 1));
        }
        for (std::size_t cell = set.first; cell <= set.last; ++cell) {
            std::visit([&](const auto& what) { apply(what, cell); }, set.what);
        }
    }

    Snapshot finish() {
        const std::size_t cells = state_.cells();
        if (cells == 0) throw Error(experiment_.source + ": no cells are created; `create` some");
        state_.mappings.assign(experiment_.mappings.size(), std::vector<double>(cells, 0.0));
        state_.birth.assign(cells, 0);
        state_.neighbours.assign(cells, 0);
        shape_lattice();
        load_fields();
        return std::move(state_);
    }

private:
    void reseed(std::int64_t seed) {
        if (experiment_.seed) seed = *experiment_.seed;
        if (seed == 0) seed = clock_ = clock_ == 0 ? seed_from_clock() : clock_;
        random_ = PublishedRandom(seed);
    }

    void reserve(std::size_t cells) {
        for (auto* columns : {&state_.conc, &state_.diff}) {
            for (std::vector<double>& column : *columns) column.reserve(cells);
        }
        for (auto* column : {&state_.x, &state_.y, &state_.polarity_x, &state_.polarity_y}) column->reserve(cells);
    }

    static bool drawn(const Spread& spread) { return static_cast<float>(spread.deviation) != 0.0f; }

    T draw(const Spread& spread) {
        if (!drawn(spread)) return static_cast<T>(spread.value);
        return random_.deviate(static_cast<float>(spread.value), static_cast<float>(spread.deviation));
    }

    Polarity draw_polarity(const std::optional<Spread>& degrees) {
        if (!degrees) return {};
        const double radians = std::numbers::pi * draw(*degrees) / 180;
        if (drawn(*degrees)) return direction(static_cast<float>(radians));
        return direction(static_cast<T>(radians));
    }

    template <class Angle>
    static Polarity direction(Angle radians) {
        return {std::cos(radians), std::sin(radians)};
    }

    void create(T x, T y, bool fixed) {
        if (state_.cells() >= largest_cell_count) {
            throw Error(fmt::format("{}: more than {} cells", experiment_.source, largest_cell_count));
        }
        state_.x.push_back(x);
        state_.y.push_back(y);
        const Polarity polarity = draw_polarity(polarity_);
        state_.polarity_x.push_back(polarity.x);
        state_.polarity_y.push_back(polarity.y);
        for (std::size_t chemical = 0; chemical < conc_.size(); ++chemical) {
            state_.conc[chemical].push_back(draw(conc_[chemical]));
            state_.diff[chemical].push_back(draw(diff_[chemical]));
        }
        state_.fixed.push_back(fixed ? 1 : 0);
    }

    void apply(const SetConcentration& set, std::size_t cell) { state_.conc[set.chemical][cell] = draw(set.value); }
    void apply(const SetRate& set, std::size_t cell) { state_.diff[set.chemical][cell] = draw(set.value); }
    void apply(const SetPolarity& set, std::size_t cell) {
        const Polarity polarity = draw_polarity(set.degrees);
        state_.polarity_x[cell] = polarity.x;
        state_.polarity_y[cell] = polarity.y;
    }
    void apply(const SetFixed&, std::size_t cell) { state_.fixed[cell] = 1; }

    // First upper with first lower case, or with the last one where a lower case letter came first.
    void pair_mirrors(const std::vector<std::uint32_t>& upper, std::vector<std::uint32_t> lower) {
        if (upper.empty() || lower.empty()) return;
        if (lower.front() < upper.front()) std::reverse(lower.begin(), lower.end());
        for (std::size_t i = 0; i < std::min(upper.size(), lower.size()); ++i) {
            state_.mirrors.emplace_back(upper[i], lower[i]);
        }
    }

    void shape_lattice() {
        const Space space = space_of(experiment_);
        const auto* lattice = std::get_if<Lattice>(&space);
        if (lattice == nullptr) return;
        state_.columns = lattice->columns;
        state_.rows = lattice->rows;
        state_.origin_x = lattice->x;
        state_.origin_y = lattice->y;
    }

    void load_fields() {
        for (std::size_t chemical = 0; chemical < experiment_.chemicals.size(); ++chemical) {
            const auto& field = experiment_.chemicals[chemical].initial;
            if (!field) continue;
            if (!state_.lattice() || field->columns != state_.columns || field->rows != state_.rows) {
                throw Error(fmt::format("{}: the picture for chemical '{}' is {} x {}; the lattice is {} x {}",
                                        experiment_.source, experiment_.chemicals[chemical].name, field->columns,
                                        field->rows, state_.columns, state_.rows));
            }
            state_.conc[chemical] = field->values;
        }
    }

    const Experiment& experiment_;
    PublishedRandom random_;
    std::int64_t clock_ = 0;  // the seed that stands for 0, once it is needed
    std::vector<Spread> conc_;
    std::vector<Spread> diff_;
    std::optional<Spread> polarity_;
    Snapshot state_;
};

struct Counter {
    std::size_t operator()(const CreateCell&) const { return 1; }
    std::size_t operator()(const CreateMatrix& matrix) const { return matrix.columns * matrix.rows; }
    std::size_t operator()(const CreateGrid& grid) const {
        const bool circle = grid.arrangement == Arrangement::sqr_circle || grid.arrangement == Arrangement::hex_circle;
        if (!circle) return grid.columns * grid.rows;
        return Circle(grid).count();
    }
    std::size_t operator()(const CreateShape& shape) const {
        std::size_t cells = 0;
        for (const std::string& line : shape.lines) {
            cells += static_cast<std::size_t>(
                std::count_if(line.begin(), line.end(), [](unsigned char c) { return std::isalpha(c) != 0; }));
        }
        return cells;
    }
    template <class Other>
    std::size_t operator()(const Other&) const {
        return 0;
    }
};

}  // namespace

namespace {

template <class T>
Snapshot built(const Experiment& experiment) {
    Builder<T> builder(experiment);
    for (const Statement& statement : experiment.prepattern) std::visit(builder, statement);
    return builder.finish();
}

}  // namespace

Snapshot initial_state(const Experiment& experiment, Precision precision) {
    return precision == Precision::double_ ? built<double>(experiment) : built<float>(experiment);
}

std::size_t count_cells(const Experiment& experiment) {
    std::size_t cells = 0;
    for (const Statement& statement : experiment.prepattern) cells += std::visit(Counter{}, statement);
    return cells;
}

}  // namespace pelage
