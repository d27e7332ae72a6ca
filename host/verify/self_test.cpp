// See self_test.hpp.
#include "verify/self_test.hpp"

#include "core/aggregate.hpp"
#include "core/columns.hpp"
#include "core/lattice.hpp"
#include "core/schedule.hpp"
#include "core/space.hpp"
#include "mesh/shapes.hpp"
#include "mesh/surface.hpp"
#include "opencl/backend.hpp"
#include "opencl/cells/together.hpp"
#include "opencl/lattice/choice.hpp"
#include "reference/backend.hpp"
#include "verify/charges_piece.hpp"
#include "verify/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <variant>
#include <vector>

namespace pelage::verify {

namespace {

constexpr std::size_t most_columns = 37;  // more than two vectors of 16
constexpr std::size_t most_rows = 13;
constexpr std::size_t most_layers = 7;  // of a volume, whose rows are fewer, too
constexpr std::size_t most_rows_of_layers = 7;
constexpr std::size_t most_cells = 90;
constexpr std::uint64_t few_iterations = 5;
constexpr double loose = 1e-3;

// Which cells of the whole are in the piece, in order of id.
std::vector<std::size_t> chosen(const Snapshot& whole, const Snapshot& piece) {
    std::vector<std::size_t> cells;
    if (!whole.on_grid()) {
        for (std::size_t cell = 0; cell < std::min(most_cells, whole.cells()); ++cell) cells.push_back(cell);
        return cells;
    }
    const std::size_t first_column = (whole.columns - piece.columns) / 2;
    const std::size_t first_row = (whole.rows - piece.rows) / 2;
    const std::size_t first_layer = (whole.layers - piece.layers) / 2;
    for (std::size_t layer = 0; layer < std::max<std::size_t>(piece.layers, 1); ++layer) {
        for (std::size_t row = 0; row < piece.rows; ++row) {
            const std::size_t line = (first_layer + layer) * whole.rows + first_row + row;
            for (std::size_t column = 0; column < piece.columns; ++column)
                cells.push_back(line * whole.columns + first_column + column);
        }
    }
    return cells;
}

template <class V>
std::vector<V> picked(const std::vector<V>& values, const std::vector<std::size_t>& cells) {
    std::vector<V> piece(cells.size());
    std::ranges::transform(cells, piece.begin(), [&](std::size_t cell) { return values[cell]; });
    return piece;
}

double centre(double origin, std::size_t at, std::size_t count) {
    const double place = origin + (static_cast<double>(at) - static_cast<double>(count) / 2) * 2 + 1;
    return static_cast<double>(static_cast<float>(place));
}

// An iteration at which each set of rules begins to act.
std::vector<std::uint64_t> beginnings(const Experiment& experiment, std::uint64_t first, std::uint64_t last,
                                      std::size_t most) {
    std::vector<std::uint64_t> iterations;
    std::set<std::pair<std::vector<bool>, const Phase*>> seen;
    constexpr int most_looks = 1000;  // rules may come and go in ever new sets
    int looks = 0;
    for (std::uint64_t at = first; at < last && looks < most_looks; at = next_change(experiment, at), ++looks) {
        if (iterations.size() == most) break;
        if (seen.emplace(active_rules(experiment, at), &experiment.phase_at(at)).second) iterations.push_back(at);
    }
    return iterations;
}

// The forms of free cells' steps that a run may take: it changes over when a small tissue has grown.
std::vector<Path> forms_of_cells(const OpenclOptions& options, const DeviceInfo& device, const Experiment& experiment,
                                 const Snapshot& initial) {
    CellsOptions cells;
    cells.search = options.neighbours;
    if (options.path != Path::automatic || cells.approximate()) return {options.path};
    const bool grows = std::ranges::any_of(
        experiment.rules, [](const Rule& rule) { return std::holds_alternative<Divide>(rule.action); });
    if (!cells_step_together(device, Path::automatic, cells, initial.cells(), grows)) return {Path::step};
    if (!grows) return {Path::shared};
    return {Path::shared, Path::step};
}

// The paths that a run over a lattice may take with each set of rules: the one for so small a piece, and the one for
// the whole, which it changes over to.
class LatticeForms {
public:
    LatticeForms(const OpenclOptions& options, const DeviceInfo& device, const Experiment& experiment,
                 const Snapshot& initial)
        : options_(options),
          device_(device),
          experiment_(experiment),
          plan_(lattice_plan(experiment, initial)),
          cells_(static_cast<double>(initial.cells())) {
        const RuleUse every = use_of(std::vector<bool>(experiment.rules.size(), true));
        bytes_ = bytes_a_cell(experiment, plan_, every, options.precision);
    }

    std::vector<Path> at(std::uint64_t iteration) const {
        const std::vector<bool> active = active_rules(experiment_, iteration);
        const RuleNeeds needs = rule_needs(experiment_, plan_, use_of(active));
        const Path small = choose(device_, needs, {}, options_).path;
        const Work work = foreseen_work(experiment_, active, iteration, cells_, bytes_);
        const Path whole = choose(device_, needs, work, options_).path;
        return whole == small ? std::vector{options_.path} : std::vector{options_.path, whole};
    }

private:
    RuleUse use_of(const std::vector<bool>& active) const {
        return emit_rules(experiment_, active, options_.precision).use;
    }

    const OpenclOptions& options_;
    const DeviceInfo& device_;
    const Experiment& experiment_;
    LatticePlan plan_;
    double cells_;
    double bytes_ = 0;
};

std::string difference(const OpenclOptions& options, const Experiment& experiment, const Snapshot& start,
                       std::uint64_t iterations) {
    const auto backend = opencl_backend(options);
    const bool exact =
        !options.fast && (options.precision == Precision::double_ || backend->device().correctly_rounded_divide_sqrt);
    const auto reference = reference_backend(options.precision, options.neighbours, options.sorting);
    const auto expected = reference->make_tissue(experiment, start);
    const auto found = backend->make_tissue(experiment, start);
    Tally tally;
    for (const std::uint64_t count : {std::uint64_t{1}, iterations - 1}) {
        if (!exact && count > 1) break;  // differences grow from step to step
        expected->advance(count);
        found->advance(count);
        add(tally, expected->read(), found->read(), options.precision,
            fmt::format("iteration {}", expected->iteration()));
    }
    if (tally.equal() || (!exact && std::min(tally.max_relative, tally.max_absolute) <= loose)) return {};
    return tally.first;
}

}  // namespace

Snapshot small_piece(const Snapshot& whole) {
    Snapshot piece = whole;
    piece.columns = std::min(whole.columns, most_columns);
    piece.rows = std::min(whole.rows, whole.volume() ? most_rows_of_layers : most_rows);
    piece.layers = std::min(whole.layers, most_layers);
    const std::vector<std::size_t> cells = chosen(whole, piece);
    each_cell_column([&](const char*, auto& column) { column = picked(column, cells); }, piece);
    piece.order.clear();
    std::erase_if(piece.mirrors,
                  [&](const auto& pair) { return pair.first >= cells.size() || pair.second >= cells.size(); });
    for (std::size_t cell = 0; piece.on_grid() && cell < cells.size(); ++cell) {
        piece.x[cell] = centre(piece.origin_x, cell % piece.columns, piece.columns);
        piece.y[cell] = centre(piece.origin_y, cell / piece.columns % piece.rows, piece.rows);
    }
    return piece;
}

namespace {

// A mesh cannot be cut out of another: a small torus with its weights takes its place, and as many of its cells.
bool make_small(Experiment& experiment, Snapshot& state) {
    for (Statement& statement : experiment.prepattern) {
        auto* create = std::get_if<CreateMesh>(&statement);
        if (create == nullptr) continue;
        const Mesh small = torus(13, 7);
        if (state.cells() <= small.vertices.size()) return true;
        std::vector<std::size_t> cells(small.vertices.size());
        std::iota(cells.begin(), cells.end(), std::size_t{0});
        each_cell_column([&](const char*, auto& column) { column = picked(column, cells); }, state);
        create->surface = make_surface(small, create->surface->weights);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            std::vector<double>& places = axis == 0 ? state.x : state.y;
            places = coordinates(*create->surface, axis);
            for (double& place : places) place = static_cast<double>(static_cast<float>(place));
        }
        return true;
    }
    return false;
}

std::string test_of_mesh(const OpenclOptions& options, const Experiment& experiment, Snapshot start,
                         std::uint64_t last) {
    for (const std::uint64_t iteration : beginnings(experiment, start.iteration, last, options.variants)) {
        start.iteration = iteration;
        const std::string found = difference(options, experiment, start, few_iterations);
        if (!found.empty()) return found;
    }
    return {};
}

}  // namespace

std::string self_test(const OpenclOptions& options, const Experiment& experiment, const Snapshot& initial,
                      std::uint64_t last) {
    Experiment small = experiment;
    Snapshot piece = initial;
    if (make_small(small, piece)) return test_of_mesh(options, small, std::move(piece), last);
    const DeviceInfo device = select_device(options.device);
    const bool charges = has_charges(experiment);
    std::optional<LatticeForms> lattice;
    if (initial.on_grid() && !charges) lattice.emplace(options, device, experiment, initial);
    Snapshot start = small_piece(initial);
    if (charges) give_charges(small, start);
    const auto forms = [&](std::uint64_t iteration) {
        if (lattice) return lattice->at(iteration);
        if (!charges) return forms_of_cells(options, device, experiment, initial);
        return options.path == Path::automatic ? std::vector{Path::step, Path::shared} : std::vector{options.path};
    };
    for (const std::uint64_t iteration : beginnings(experiment, initial.iteration, last, options.variants)) {
        start.iteration = iteration;
        // Parameters of an aggregate need not mean anything later.
        const std::uint64_t count = charges ? std::min(few_iterations, last - iteration) : few_iterations;
        for (const Path path : forms(iteration)) {
            OpenclOptions own = options;
            own.path = path;
            const std::string found = difference(own, small, start, count);
            if (!found.empty()) return path == options.path ? found : fmt::format("{} ({})", found, word(path));
        }
    }
    return {};
}

}  // namespace pelage::verify
