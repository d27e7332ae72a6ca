// See texture.hpp.
#include "io/texture.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/space.hpp"
#include "core/visit.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nanoflann.hpp>
#include <variant>

namespace pelage {
namespace {

constexpr std::size_t spacing_neighbours = 6;
constexpr double reach_in_spacings = 1.5;
constexpr double reach_in_texels = 1.0;

// Mean distance of the nearest six on a square lattice of spacing 2.
const double lattice_spacing = (4 * 2.0 + 2 * std::sqrt(8.0)) / 6;

// Cells' places as nanoflann wants them.
struct Points {
    const Snapshot& cells;
    std::size_t kdtree_get_point_count() const { return cells.cells(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return axis == 0 ? cells.x[i] : cells.y[i]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 2, std::size_t>;

// The texture's window on the tissue, lowest row first.
struct Window {
    double left, bottom;   // of the whole texture
    double width, height;  // of one texel
    std::size_t columns, rows;
    bool wrap;
};

Window lattice_window(const Snapshot& cells, std::size_t columns, std::size_t rows, bool wrap) {
    const auto across = static_cast<double>(cells.columns);
    const auto up = static_cast<double>(cells.rows);
    return {cells.origin_x - across,
            cells.origin_y - up,
            2 * across / static_cast<double>(columns),
            2 * up / static_cast<double>(rows),
            columns,
            rows,
            wrap};
}

Window cells_window(const Snapshot& cells, std::size_t columns, std::size_t rows) {
    const auto [left, right] = std::minmax_element(cells.x.begin(), cells.x.end());
    const auto [bottom, top] = std::minmax_element(cells.y.begin(), cells.y.end());
    const double side =
        std::max((*right - *left + 2) / static_cast<double>(columns), (*top - *bottom + 2) / static_cast<double>(rows));
    return {(*left + *right - side * static_cast<double>(columns)) / 2,
            (*bottom + *top - side * static_cast<double>(rows)) / 2,
            side,
            side,
            columns,
            rows,
            false};
}

double spacing_around(const Tree& tree, const Snapshot& cells, std::size_t cell) {
    std::size_t ids[spacing_neighbours + 1];
    double squares[spacing_neighbours + 1];
    const double place[2] = {cells.x[cell], cells.y[cell]};
    const auto found = tree.knnSearch(place, spacing_neighbours + 1, ids, squares);
    double sum = 0.0;
    for (std::size_t i = 0; i < found; ++i) sum += std::sqrt(squares[i]);
    return found > 1 ? sum / static_cast<double>(found - 1) : 0.0;  // the cell itself adds 0
}

std::size_t nearest_cell(const Tree& tree, const Window& window, std::size_t texel) {
    const auto row = texel / window.columns;
    const auto column = texel % window.columns;
    const double place[2] = {window.left + (static_cast<double>(column) + 0.5) * window.width,
                             window.bottom + (static_cast<double>(row) + 0.5) * window.height};
    std::size_t nearest = 0;
    double square = 0.0;
    tree.knnSearch(place, 1, &nearest, &square);
    return nearest;
}

double weight(double square) {  // of q^2 < 1
    const double q = std::sqrt(square);
    const double rest = (1 - q) * (1 - q);
    return rest * rest * (4 * q + 1) / (square + 0.25);
}

// Sums of weighted values, texel by texel.
class Sums {
public:
    Sums(const Window& window, std::size_t fields)
        : window_(window), fields_(fields), weights_(window.columns * window.rows), sums_(fields * weights_.size()) {}

    void add(double x, double y, double reach, const std::vector<std::vector<double>>& values, std::size_t cell) {
        const auto [first_row, last_row] =
            range((y - window_.bottom) / window_.height, reach / window_.height, window_.rows);
        const auto [first, last] = range((x - window_.left) / window_.width, reach / window_.width, window_.columns);
        for (auto row = first_row; row <= last_row; ++row) {
            const double dy = (window_.bottom + (static_cast<double>(row) + 0.5) * window_.height - y) / reach;
            for (auto column = first; column <= last; ++column) {
                const double dx = (window_.left + (static_cast<double>(column) + 0.5) * window_.width - x) / reach;
                const double square = dx * dx + dy * dy;
                if (square >= 1.0) continue;
                add_to(wrapped(row, window_.rows) * window_.columns + wrapped(column, window_.columns), weight(square),
                       values, cell);
            }
        }
    }

    double weight_of(std::size_t texel) const { return weights_[texel]; }
    double mean(std::size_t texel, std::size_t field) const { return sums_[texel * fields_ + field] / weights_[texel]; }

private:
    // Texels whose centres may lie within reach; without wrap only those inside.
    std::pair<std::int64_t, std::int64_t> range(double at, double reach, std::size_t count) const {
        const auto last = static_cast<double>(count) - 1;
        double low = std::ceil(at - reach - 0.5);  // centres are at halves
        double high = std::floor(at + reach - 0.5);
        if (!window_.wrap) {
            low = std::clamp(low, 0.0, last + 1);
            high = std::clamp(high, -1.0, last);
        }
        return {static_cast<std::int64_t>(low), static_cast<std::int64_t>(high)};
    }

    static std::size_t wrapped(std::int64_t index, std::size_t count) {
        const auto length = static_cast<std::int64_t>(count);
        return static_cast<std::size_t>((index % length + length) % length);
    }

    void add_to(std::size_t texel, double share, const std::vector<std::vector<double>>& values, std::size_t cell) {
        weights_[texel] += share;
        for (std::size_t field = 0; field < fields_; ++field)
            sums_[texel * fields_ + field] += share * values[field][cell];
    }

    Window window_;
    std::size_t fields_;
    std::vector<double> weights_;
    std::vector<double> sums_;  // [texel][field]
};

void check(const Snapshot& cells, const std::vector<std::vector<double>>& values, std::size_t columns,
           std::size_t rows) {
    if (cells.cells() == 0 || columns == 0 || rows == 0 || columns > largest_cell_count / rows) {
        throw Error(fmt::format("{} cannot make a texture of {} x {}", counted(cells.cells(), "cell"), columns, rows));
    }
    for (const auto& one : values) {
        if (one.size() != cells.cells())
            throw Error(
                fmt::format("there are {} for {}", counted(one.size(), "value"), counted(cells.cells(), "cell")));
    }
    for (std::size_t i = 0; i < cells.cells(); ++i) {
        if (!std::isfinite(cells.x[i]) || !std::isfinite(cells.y[i])) {
            throw Error(fmt::format("cell {} is at ({}, {}), which makes no texture", i, cells.x[i], cells.y[i]));
        }
    }
}

}  // namespace

std::vector<Field> interpolate(const Snapshot& cells, const std::vector<std::vector<double>>& values,
                               std::size_t columns, std::size_t rows, bool wrap) {
    check(cells, values, columns, rows);
    const auto window =
        cells.lattice() ? lattice_window(cells, columns, rows, wrap) : cells_window(cells, columns, rows);
    const Points points{cells};
    std::unique_ptr<Tree> tree;
    const auto find_tree = [&]() -> const Tree& {
        if (!tree) tree = std::make_unique<Tree>(2, points);
        return *tree;
    };
    Sums sums(window, values.size());
    for (std::size_t i = 0; i < cells.cells(); ++i) {
        const double spacing = cells.lattice() ? lattice_spacing : spacing_around(find_tree(), cells, i);
        const double reach =
            std::max(reach_in_spacings * spacing, reach_in_texels * std::max(window.width, window.height));
        sums.add(cells.x[i], cells.y[i], reach, values, i);
    }

    std::vector<Field> result(values.size(), Field{columns, rows, std::vector<double>(columns * rows)});
    for (std::size_t texel = 0; texel < columns * rows; ++texel) {
        const bool reached = sums.weight_of(texel) > 0.0;
        const auto nearest = reached ? 0 : nearest_cell(find_tree(), window, texel);
        for (std::size_t field = 0; field < values.size(); ++field) {
            result[field].values[texel] = reached ? sums.mean(texel, field) : values[field][nearest];
        }
    }
    return result;
}

std::array<double, 2> texel_size(const Snapshot& cells, std::size_t columns, std::size_t rows) {
    const auto window =
        cells.lattice() ? lattice_window(cells, columns, rows, false) : cells_window(cells, columns, rows);
    return {window.width, window.height};
}

bool wraps(const Experiment& experiment) {
    return std::visit(Overloaded{[](const Lattice& lattice) { return lattice.boundary == Boundary::wrap; },
                                 [](const Volume& volume) { return volume.boundary == Boundary::wrap; },
                                 [](const FreeCells&) { return false; }, [](const MeshCells&) { return false; }},
                      space_of(experiment));
}

}  // namespace pelage
