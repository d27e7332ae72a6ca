// create cell | sqr_grid | sqr_circle | hex_grid | hex_circle | shape | matrix | charges | volume | mesh | icosphere |
// torus
#include "core/aggregate.hpp"
#include "core/prepattern.hpp"
#include "io/sha256.hpp"
#include "language/mesh.hpp"
#include "language/shape.hpp"
#include "language/statements.hpp"
#include "language/vocabulary.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace pelage::language {

namespace {

struct Placement {
    double x = 0.0, y = 0.0;
    double deviation = 0.0;
    bool fixed = false;
    bool wrap = false;
};

Placement parse_placement(Cursor& cursor, Words words) {
    Placement placement;
    Options options(words);
    while (const auto option = options.next(cursor)) {
        const std::string_view word = words[*option];
        if (word == "at") {
            placement.x = cursor.number("the centre's x");
            placement.y = cursor.number("the centre's y");
        } else if (word == "dev") {
            placement.deviation = cursor.number("the deviation", not_negative);
        } else if (word == "fixed") {
            placement.fixed = true;
        } else {
            placement.wrap = true;
        }
    }
    return placement;
}

std::size_t parse_size(Cursor& cursor, std::string_view what) { return cursor.integer(what, 1, largest_cell_count); }

// Refuses what cannot be allowed before anything is counted.
void check_product(const Cursor& cursor, const Token& at, double cells) {
    if (cells <= static_cast<double>(largest_cell_count)) return;
    cursor.fail(
        at, fmt::format("'{}' makes about {:.3g} cells; at most {} are allowed", at.text, cells, largest_cell_count));
}

std::size_t count(const CreateGrid& grid) {
    Experiment alone;
    alone.prepattern.emplace_back(grid);
    return count_cells(alone);
}

void create_cell(Script& script, Cursor& cursor, const Token& at) {
    CreateCell cell;
    cell.x = cursor.number("the cell's x");
    cell.y = cursor.number("the cell's y");
    cell.fixed = cursor.take("fixed");
    script.create(cursor, at, cell, 1);
}

void create_grid(Script& script, Cursor& cursor, const Token& at, Arrangement arrangement) {
    static constexpr std::array<std::string_view, 4> words{"at", "dev", "fixed", "wrap"};
    const bool square = arrangement == Arrangement::sqr_grid;
    const std::size_t columns = parse_size(cursor, "the number of columns");
    const std::size_t rows = parse_size(cursor, "the number of rows");
    check_product(cursor, at, static_cast<double>(columns) * static_cast<double>(rows));
    const Placement place = parse_placement(cursor, Words(words).first(square ? 4 : 3));
    const CreateGrid grid{arrangement, columns, rows, place.x, place.y, place.deviation, place.fixed, place.wrap};
    script.create(cursor, at, grid, columns * rows);
}

void create_circle(Script& script, Cursor& cursor, const Token& at, Arrangement arrangement) {
    static constexpr std::array<std::string_view, 3> words{"at", "dev", "fixed"};
    const bool square = arrangement == Arrangement::sqr_circle;
    const std::size_t size = parse_size(cursor, square ? "the diameter" : "the radius");
    const double area =
        static_cast<double>(size) * static_cast<double>(size) * std::numbers::pi / (square ? 4.0 : 3.4642);
    check_product(cursor, at, area);
    const Placement place = parse_placement(cursor, words);
    const CreateGrid grid{arrangement, size, 0, place.x, place.y, place.deviation, place.fixed, false};
    script.create(cursor, at, grid, count(grid));
}

void create_shape(Script& script, Cursor& cursor, const Token& at) {
    static constexpr std::array<std::string_view, 2> words{"at", "fixed"};
    const Token& file = cursor.text("the shape file's name");
    const Placement place = parse_placement(cursor, words);
    CreateShape shape;
    try {
        const auto path = script.resolve(file.text);
        const std::string bytes = read_shape_text(path);
        shape.lines = shape_lines(bytes, path);
        script.experiment.inputs.push_back({std::string(file.text), sha256(bytes)});
    } catch (const Error& error) {
        cursor.fail(file, error.what());
    }
    shape.x = place.x;
    shape.y = place.y;
    shape.fixed = place.fixed;
    const std::size_t cells = count_letters(shape.lines);
    script.create(cursor, at, shape, cells);
}

constexpr std::array<std::string_view, 3> boundary_words{"no-flux", "wrap", "absorbing"};
constexpr std::array boundaries{Boundary::no_flux, Boundary::wrap, Boundary::absorbing};

// (EXPRESSION), which becomes a field without a name.
std::size_t parse_open_sites(Script& script, Cursor& cursor) {
    const Token& at = cursor.peek();
    auto& fields = script.experiment.fields;
    if (fields.size() == largest_field_count) {
        cursor.fail(at, fmt::format("'where' makes a field, and that is one too many; at most {} are allowed",
                                    largest_field_count));
    }
    ComputedField open{parse_expression(script, cursor, Scope::field, "what holds for the sites of charges")};
    fields.push_back({"", cursor.line(), std::move(open)});
    return fields.size() - 1;
}

// COLUMNS ROWS [at X Y] [where (EXPRESSION)]
void create_charges(Script& script, Cursor& cursor, const Token& at) {
    static constexpr std::array<std::string_view, 2> words{"at", "where"};
    CreateMatrix sites;
    sites.charges = true;
    sites.columns = cursor.integer("the number of columns", 1, widest_aggregate);
    sites.rows = cursor.integer("the number of rows", 1, widest_aggregate);
    Options options(words);
    while (const auto option = options.next(cursor)) {
        if (*option == 1) {
            sites.where = parse_open_sites(script, cursor);
            continue;
        }
        sites.x = cursor.number("the centre's x");
        sites.y = cursor.number("the centre's y");
    }
    script.create(cursor, at, sites, sites.columns * sites.rows);
}

void create_matrix(Script& script, Cursor& cursor, const Token& at) {
    static constexpr std::array<std::string_view, 4> words{boundary_words[0], boundary_words[1], boundary_words[2],
                                                           "at"};
    CreateMatrix matrix;
    matrix.columns = parse_size(cursor, "the number of columns");
    matrix.rows = parse_size(cursor, "the number of rows");
    check_product(cursor, at, static_cast<double>(matrix.columns) * static_cast<double>(matrix.rows));
    Options options(words);
    bool bounded = false;
    while (true) {
        const Token& token = cursor.peek();
        const auto option = options.next(cursor);
        if (!option) break;
        if (*option == 3) {
            matrix.x = cursor.number("the centre's x");
            matrix.y = cursor.number("the centre's y");
            continue;
        }
        if (bounded) cursor.fail(token, fmt::format("'{}' is a second boundary; a matrix has one", token.text));
        bounded = true;
        matrix.boundary = boundaries[*option];
    }
    script.create(cursor, at, matrix, matrix.columns * matrix.rows);
}

// COLUMNS ROWS LAYERS [no-flux | wrap | absorbing]
void create_volume(Script& script, Cursor& cursor, const Token& at) {
    CreateVolume volume;
    volume.columns = parse_size(cursor, "the number of columns");
    volume.rows = parse_size(cursor, "the number of rows");
    volume.layers = parse_size(cursor, "the number of layers");
    const double layer = static_cast<double>(volume.columns) * static_cast<double>(volume.rows);
    check_product(cursor, at, layer * static_cast<double>(volume.layers));
    if (!cursor.done()) volume.boundary = boundaries[cursor.choose(boundary_words)];
    script.create(cursor, at, volume, volume.columns * volume.rows * volume.layers);
}

}  // namespace

std::vector<std::string_view> words_of_boundaries() { return {boundary_words.begin(), boundary_words.end()}; }

void parse_create(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 12> words{"sqr_grid", "sqr_circle", "hex_grid",  "hex_circle",
                                                            "cell",     "shape",      "matrix",    "charges",
                                                            "volume",   "mesh",       "icosphere", "torus"};
    const Token& at = cursor.peek();
    const std::size_t kind = cursor.choose(words);
    script.outside_phases(cursor, at, "create");
    switch (kind) {
        case 0:
            return create_grid(script, cursor, at, Arrangement::sqr_grid);
        case 1:
            return create_circle(script, cursor, at, Arrangement::sqr_circle);
        case 2:
            return create_grid(script, cursor, at, Arrangement::hex_grid);
        case 3:
            return create_circle(script, cursor, at, Arrangement::hex_circle);
        case 4:
            return create_cell(script, cursor, at);
        case 5:
            return create_shape(script, cursor, at);
        case 6:
            return create_matrix(script, cursor, at);
        case 7:
            return create_charges(script, cursor, at);
        case 8:
            return create_volume(script, cursor, at);
        default:
            return create_mesh(script, cursor, at);
    }
}

}  // namespace pelage::language
