// See prepattern.hpp.
#include "core/prepattern.hpp"
#include "core/space.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ctime>
#include <numbers>

namespace pelage {

PublishedRandom::PublishedRandom(std::uint32_t seed) {
    std::int64_t word = seed == 0 ? 1 : static_cast<std::int32_t>(seed);
    for (std::uint32_t& slot : words_) {
        slot = static_cast<std::uint32_t>(word);
        word = 16807 * word % 2147483647;  // Lehmer's rule, kept positive
        if (word < 0) word += 2147483647;
    }
    for (int i = 0; i < 310; ++i) next();
}

std::uint32_t PublishedRandom::next() {
    words_[front_] += words_[back_];
    const std::uint32_t drawn = words_[front_] >> 1;
    front_ = (front_ + 1) % words_.size();
    back_ = (back_ + 1) % words_.size();
    return drawn;
}

float PublishedRandom::range(float low, float high) {
    return low + (high - low) * (static_cast<float>(next()) / 2147483647.0f);
}

float PublishedRandom::deviate(float value, float deviation) {
    return deviation == 0.0f ? value : range(value - deviation, value + deviation);
}

namespace {

// x and y are rounded to float at the same places as in the published program.
float spaced(float centre, std::int64_t i, std::int64_t count) {
    return static_cast<float>(centre + (static_cast<double>(i) - static_cast<double>(count) / 2.0) * 2 + 1);
}

// The square of elements from which a sqr_circle or hex_circle is cut.
class Circle {
public:
    struct Element {
        float x, y;
        bool right;  // not left of the centre
        bool inside;
    };

    explicit Circle(const CreateGrid& grid)
        : hex_(grid.arrangement == Arrangement::hex_circle),
          n_(static_cast<std::int64_t>(grid.columns)),
          x_(static_cast<float>(grid.x)),
          y_(static_cast<float>(grid.y)) {}

    std::int64_t begin() const { return hex_ ? -n_ : 0; }  // of rows and columns; both end at n
    Element at(std::int64_t row, std::int64_t column) const { return hex_ ? hex(row, column) : square(row, column); }

    // Elements inside, without visiting each: those of a row are one stretch, left and right of the centre.
    std::size_t count() const {
        std::int64_t cells = 0;
        for (std::int64_t row = begin(); row < n_; ++row) {
            const std::int64_t middle = first(begin(), n_, [&](std::int64_t i) { return at(row, i).right; });
            cells += first(middle, n_, [&](std::int64_t i) { return !at(row, i).inside; });
            cells -= first(begin(), middle, [&](std::int64_t i) { return at(row, i).inside; });
        }
        return static_cast<std::size_t>(cells);
    }

private:
    Element square(std::int64_t row, std::int64_t column) const {
        const double half = static_cast<double>(n_) / 2.0;
        const double dy = static_cast<double>(row) - half + 0.5;
        const double dx = static_cast<double>(column) - half + 0.5;
        return {spaced(x_, column, n_), spaced(y_, row, n_), dx >= 0.0, dy * dy + dx * dx <= half * half};
    }

    Element hex(std::int64_t row, std::int64_t column) const {
        const float radius2 = static_cast<float>(n_ * n_);
        const float y = y_ + static_cast<float>(row) * 1.7321f;
        float x = x_ + static_cast<float>(column * 2);
        if (row % 2 != 0) x += 1.0f;
        const float dx = x - x_;
        const float dy = y - y_;
        return {x, y, dx >= 0.0f, dx * dx + dy * dy <= radius2};
    }

    // The first i from `low` on for which `holds`, which stays true once it is; `high` when there is none.
    template <class Holds>
    static std::int64_t first(std::int64_t low, std::int64_t high, Holds holds) {
        while (low < high) {
            const std::int64_t middle = low + (high - low) / 2;
            if (holds(middle))
                high = middle;
            else
                low = middle + 1;
        }
        return low;
    }

    bool hex_;
    std::int64_t n_;
    float x_, y_;
};

// Calls each(x, y) for the centre of every cell of a grid or circle, in order of creation.
template <class Each>
void for_each_centre(const CreateGrid& grid, Each each) {
    const float centre_x = static_cast<float>(grid.x);
    const float centre_y = static_cast<float>(grid.y);
    const auto n = static_cast<std::int64_t>(grid.columns);
    switch (grid.arrangement) {
        case Arrangement::sqr_grid:
        case Arrangement::hex_grid: {
            const auto rows = static_cast<std::int64_t>(grid.rows);
            const bool hex = grid.arrangement == Arrangement::hex_grid;
            for (std::int64_t row = 0; row < rows; ++row) {
                const float place = static_cast<float>(row) - static_cast<float>(rows) / 2.0f;
                const float y = hex ? centre_y + place * 1.7321f + 0.866f : spaced(centre_y, row, rows);
                for (std::int64_t column = 0; column < n; ++column) {
                    const float x = spaced(centre_x, column, n);
                    each(hex && row % 2 != 0 ? x + 1.0f : x, y);
                }
            }
            break;
        }
        case Arrangement::sqr_circle:
        case Arrangement::hex_circle: {
            const Circle circle(grid);
            for (std::int64_t row = circle.begin(); row < n; ++row) {
                for (std::int64_t column = circle.begin(); column < n; ++column) {
                    const Circle::Element element = circle.at(row, column);
                    if (element.inside) each(element.x, element.y);
                }
            }
            break;
        }
    }
}

struct Polarity {
    float x = 0.0f;
    float y = 0.0f;
};

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
    void operator()(const CreateCell& cell) {
        create(static_cast<float>(cell.x), static_cast<float>(cell.y), cell.fixed);
    }

    void operator()(const CreateGrid& grid) {
        const float dev = static_cast<float>(grid.deviation);
        reserve(state_.cells() + grid.columns * std::max<std::size_t>(grid.rows, 1));
        for_each_centre(grid, [&](float x, float y) {
            if (dev == 0.0f) return create(x, y, grid.fixed);
            // The published program draws y first, and its jitter lies in [-2 dev, 0].
            const float jitter_y = random_.range(-dev - dev, -dev + dev);
            const float jitter_x = random_.range(-dev - dev, -dev + dev);
            create(x + jitter_x, y + jitter_y, grid.fixed);
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
            const float y = static_cast<float>(static_cast<float>(shape.y) + up * 2);
            for (std::size_t column = 0; column < shape.lines[row].size(); ++column) {
                const auto letter = static_cast<unsigned char>(shape.lines[row][column]);
                if (std::isalpha(letter) == 0) continue;
                const double across = static_cast<double>(column) - static_cast<double>(columns) / 2.0;
                const auto id = static_cast<std::uint32_t>(state_.cells());
                create(static_cast<float>(static_cast<float>(shape.x) + across * 2), y, shape.fixed);
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
        if (seed == 0) seed = std::time(nullptr);
        random_ = PublishedRandom(static_cast<std::uint32_t>(seed));
    }

    void reserve(std::size_t cells) {
        for (auto* columns : {&state_.conc, &state_.diff}) {
            for (std::vector<double>& column : *columns) column.reserve(cells);
        }
        for (auto* column : {&state_.x, &state_.y, &state_.polarity_x, &state_.polarity_y}) column->reserve(cells);
    }

    float draw(const Spread& spread) {
        return random_.deviate(static_cast<float>(spread.value), static_cast<float>(spread.deviation));
    }

    Polarity draw_polarity(const std::optional<Spread>& degrees) {
        if (!degrees) return {};
        const double radians = std::numbers::pi * draw(*degrees) / 180;
        return {std::cos(static_cast<float>(radians)), std::sin(static_cast<float>(radians))};
    }

    void create(float x, float y, bool fixed) {
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

Snapshot initial_state(const Experiment& experiment) {
    Builder builder(experiment);
    for (const Statement& statement : experiment.prepattern) std::visit(builder, statement);
    return builder.finish();
}

std::size_t count_cells(const Experiment& experiment) {
    std::size_t cells = 0;
    for (const Statement& statement : experiment.prepattern) cells += std::visit(Counter{}, statement);
    return cells;
}

}  // namespace pelage
