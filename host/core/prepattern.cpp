// See prepattern.hpp.
#include "core/prepattern.hpp"

#include "core/arrangements.hpp"
#include "core/digits.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/philox.hpp"
#include "core/published_random.hpp"
#include "core/scene.hpp"
#include "core/seed.hpp"
#include "core/space.hpp"
#include "core/stands.hpp"
#include "core/subnormal.hpp"
#include "core/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <type_traits>

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

    // Layer after layer, each with its centre in (0, 0).
    void operator()(const CreateVolume& volume) {
        reserve(state_.cells() + volume.columns * volume.rows * volume.layers);
        const CreateGrid layer{Arrangement::sqr_grid, volume.columns, volume.rows, 0.0, 0.0, 0.0, false, false};
        for (std::size_t nth = 0; nth < volume.layers; ++nth)
            for_each_centre<T>(layer, [&](T x, T y) { create(x, y, false); });
    }

    void operator()(const CreateMesh& mesh) {
        reserve(state_.cells() + mesh.surface->cells());
        for (const Point& place : mesh.surface->mesh.vertices)
            create(static_cast<T>(place[0]), static_cast<T>(place[1]), false);
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

    // Carries out the `place`th statement.
    void take(const Statement& statement, std::size_t place) {
        place_ = place;
        const std::size_t before = state_.cells();
        std::visit(*this, statement);
        if (state_.cells() == before) return;
        for (std::size_t chemical = 0; chemical < conc_.size(); ++chemical) {
            compute(chemical, false, before);
            compute(chemical, true, before);
        }
    }

    void operator()(const SetCells& set) {
        const std::size_t first = set.where ? 0 : set.first;
        const std::size_t last = set.where ? state_.cells() - 1 : set.last;
        if (last < first || last >= state_.cells()) {
            throw Error(fmt::format("{}: `set` names cells {} to {}; cells 0 to {} exist", experiment_.source, first,
                                    last, static_cast<std::int64_t>(state_.cells()) - 1));
        }
        // All that one line sets is set in the same cells.
        if (set.where && set.where != where_of_) where_ = values(*set.where, 0);
        where_of_ = set.where;
        computed_ = expression_of(set.what) ? values(*expression_of(set.what), 1) : std::vector<double>();
        for (std::size_t cell = first; cell <= last; ++cell) {
            if (set.where && where_[cell] == 0.0) continue;
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
        if (spread.expression) return T(0);  // until compute()
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

    // ---- expressions

    static std::optional<std::size_t> expression_of(const decltype(SetCells::what)& what) {
        if (const auto* set = std::get_if<SetConcentration>(&what)) return set->value.expression;
        if (const auto* set = std::get_if<SetRate>(&what)) return set->value.expression;
        return std::nullopt;
    }

    // Those of a lattice are the same for all expressions, those of free cells are computed where the cells are.
    const std::vector<std::vector<double>>& fields_for(Scene& scene) {
        const Space space = space_of(experiment_);
        if (const auto* lattice = std::get_if<Lattice>(&space)) {
            scene.columns = lattice->columns;
            scene.rows = lattice->rows;
            constexpr Precision precision = std::is_same_v<T, float> ? Precision::single_ : Precision::double_;
            if (fields_.empty())
                fields_ =
                    field_values(experiment_, {lattice->columns, lattice->rows, lattice->x, lattice->y}, precision);
            return fields_;
        }
        if (const auto* volume = std::get_if<Volume>(&space)) {
            scene.columns = volume->columns;
            scene.rows = volume->rows;
            scene.layers = volume->layers;
            if (fields_.empty())
                fields_ = field_values(experiment_, {volume->columns, volume->rows, 0.0, 0.0, volume->layers},
                                       std::is_same_v<T, float> ? Precision::single_ : Precision::double_);
            return fields_;
        }
        if (const auto* mesh = std::get_if<MeshCells>(&space)) {
            for (const double z : coordinates(*mesh->surface, 2)) scene.z.push_back(double{in_precision<T>(z)});
            if (blobs_.empty())
                blobs_ = mesh_blobs(experiment_, *mesh->surface,
                                    std::is_same_v<T, float> ? Precision::single_ : Precision::double_);
        }
        fields_.clear();
        scene.fields = &fields_;
        for (std::size_t i = 0; i < experiment_.fields.size(); ++i) {
            const auto* computed = std::get_if<ComputedField>(&experiment_.fields[i].source);
            fields_.push_back(computed != nullptr ? evaluate(computed->expression, scene) : blobs_.at(i));
        }
        return fields_;
    }

    // Of the cells from `first` on. `nth`: which of the statement's expressions it is, for its draws.
    std::vector<double> values(std::size_t expression, std::uint32_t nth, std::size_t first = 0) {
        Scene scene;
        scene.first = first;
        scene.x.assign(state_.x.begin() + static_cast<std::ptrdiff_t>(first), state_.x.end());
        scene.y.assign(state_.y.begin() + static_cast<std::ptrdiff_t>(first), state_.y.end());
        scene.fields = &fields_for(scene);
        scene.conc = &state_.conc;
        scene.diff = &state_.diff;
        scene.seed = experiment_.run_seed();
        scene.place = static_cast<std::uint32_t>(place_);
        scene.purpose = purpose::start + (nth << 16);
        std::vector<double> found = evaluate(experiment_.expressions[expression], scene);
        for (double& value : found) value = double{in_precision<T>(value)};
        return found;
    }

    // The values of the cells from `first` on, where the spread is an expression.
    void compute(std::size_t chemical, bool rate, std::size_t first) {
        const Spread& spread = (rate ? diff_ : conc_)[chemical];
        if (!spread.expression) return;
        const std::vector<double> found =
            values(*spread.expression, static_cast<std::uint32_t>(2 * chemical + (rate ? 1 : 0)), first);
        std::vector<double>& column = (rate ? state_.diff : state_.conc)[chemical];
        for (std::size_t cell = first; cell < column.size(); ++cell) {
            judge(*spread.expression, chemical, rate, found[cell - first], cell);
            column[cell] = found[cell - first];
        }
    }

    // What an expression gives must lie within the bounds of the first phase, a rate not below 0.
    void judge(std::size_t expression, std::size_t chemical, bool rate, double value, std::size_t cell) const {
        Bounds allowed;
        if (!rate) {
            const Bounds& bounds = experiment_.phases.front().bounds[chemical];
            allowed = {double{in_precision<T>(bounds.floor)}, double{in_precision<T>(bounds.limit)}};
        }
        if (value >= allowed.floor && value <= allowed.limit && std::isfinite(value)) return;
        refuse(experiment_.expressions[expression], chemical, cell, rate ? "diffusion rate" : "concentration", value,
               allowed);
    }
    static std::string interval(const Bounds& allowed) {
        const bool low = std::isfinite(allowed.floor), high = std::isfinite(allowed.limit);
        if (low && high) return fmt::format("a number from {} to {}", digits(allowed.floor), digits(allowed.limit));
        if (low) return fmt::format("a number not below {}", digits(allowed.floor));
        return high ? fmt::format("a number not above {}", digits(allowed.limit)) : "a finite number";
    }
    [[noreturn]] void refuse(const Expression& expression, std::size_t chemical, std::size_t cell, const char* what,
                             double found, const Bounds& allowed) const {
        throw Error(fmt::format("{}: an expression starts '{}' with the {} {} in cell {}; it must be {}",
                                where_stands(experiment_, expression.line, expression.text),
                                experiment_.chemicals[chemical].name, what,
                                std::isnan(found) ? "no number" : digits(found), cell, interval(allowed)));
    }

    T amount(std::size_t chemical, bool rate, const Spread& spread, std::size_t cell) {
        if (!spread.expression) return draw(spread);
        judge(*spread.expression, chemical, rate, computed_[cell], cell);
        return static_cast<T>(computed_[cell]);
    }
    void apply(const SetConcentration& set, std::size_t cell) {
        state_.conc[set.chemical][cell] = amount(set.chemical, false, set.value, cell);
    }
    void apply(const SetRate& set, std::size_t cell) {
        state_.diff[set.chemical][cell] = amount(set.chemical, true, set.value, cell);
    }
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
        if (const auto* volume = std::get_if<Volume>(&space)) {
            state_.columns = volume->columns;
            state_.rows = volume->rows;
            state_.layers = volume->layers;
        }
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
    std::size_t place_ = 0;                // of the statement at hand
    std::vector<double> computed_;         // values of a `set`
    std::optional<std::size_t> where_of_;  // the expression of the last `set`, and where it is true
    std::vector<double> where_;
    std::vector<std::vector<double>> fields_;
    std::vector<std::vector<double>> blobs_;  // of a mesh
};

struct Counter {
    std::size_t operator()(const CreateCell&) const { return 1; }
    std::size_t operator()(const CreateMatrix& matrix) const { return matrix.columns * matrix.rows; }
    std::size_t operator()(const CreateMesh& mesh) const { return mesh.surface->cells(); }
    std::size_t operator()(const CreateVolume& volume) const { return volume.columns * volume.rows * volume.layers; }
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
    for (std::size_t place = 0; place < experiment.prepattern.size(); ++place)
        builder.take(experiment.prepattern[place], place);
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
