// Which pixels a cell covers, and in which colour.
#include "io/draw_cells.hpp"
#include "core/error.hpp"
#include "io/colour.hpp"
#include "scratch.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using Catch::Matchers::Contains;
using namespace pelage;

namespace {

constexpr Rgb white{255, 255, 255};
constexpr Rgb black{0, 0, 0};
constexpr Rgb blue_cell{0, 0, 255};
constexpr Rgb red_cell{255, 0, 0};

CellDrawing drawing(CellShape shape, std::size_t size, bool marks = false) { return {shape, marks, size}; }

std::size_t count(const Picture& picture, const Rgb& colour) {
    return static_cast<std::size_t>(std::count(picture.pixels.begin(), picture.pixels.end(), colour));
}

// Share of the picture that is not white, edge pixels by their coverage; for cells drawn in black.
double covered(const Picture& picture) {
    double sum = 0;
    for (const auto& pixel : picture.pixels) sum += 1 - pixel[0] / 255.0;
    return sum / static_cast<double>(picture.pixels.size());
}

Output all_black() { return {0, {"stops", {{0.0, black}}}, {{-1000.0, 1000.0}}}; }

}  // namespace

TEST_CASE("two cells side by side: bounding box, colours, background") {
    const auto cells = test::cells({0, 6}, {0, 2});

    const auto picture = draw_cells(cells, Output{}, drawing(CellShape::circle, 80));

    // 8 x 4 units at 10 pixels each; the first cell's centre is at (10, 30) from the top left, the second's at (70,
    // 10).
    CHECK(picture.columns == 80);
    CHECK(picture.rows == 40);
    CHECK(picture.at(10, 30) == blue_cell);
    CHECK(picture.at(70, 10) == red_cell);
    CHECK(picture.at(10, 21) == blue_cell);
    CHECK(picture.at(1, 30) == blue_cell);
    CHECK(picture.at(21, 30) == white);
    CHECK(picture.at(10, 10) == white);
    CHECK(picture.at(0, 39) == white);
    CHECK(count(picture, blue_cell) == count(picture, red_cell));
}

TEST_CASE("a circle and a hexagon cover their areas, with smooth edges") {
    const auto cell = test::cells({5}, {-3});

    const auto circle = draw_cells(cell, all_black(), drawing(CellShape::circle, 200));
    const auto hexagon = draw_cells(cell, all_black(), drawing(CellShape::hexagon, 240));

    CHECK(circle.columns == 200);
    CHECK(hexagon.columns == 240);
    CHECK(covered(circle) == Approx(std::acos(-1.0) / 4).margin(0.002));
    CHECK(covered(hexagon) == Approx(2 * std::sqrt(3.0) / (2.4 * 2.4)).margin(0.002));
    CHECK(count(circle, black) + count(circle, white) < circle.pixels.size());
    // A hexagon points up and is as wide as the circle.
    CHECK(hexagon.at(120, 7) == black);
    CHECK(hexagon.at(120, 3) == white);
    CHECK(hexagon.at(22, 120) == black);
    CHECK(hexagon.at(18, 120) == white);
}

TEST_CASE("hexagons of a hexagonal grid close up") {
    std::vector<double> x;
    std::vector<double> y;
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 5; ++column) {
            x.push_back(2 * column + row % 2);
            y.push_back(1.7321 * row);
        }
    }

    const auto picture = draw_cells(test::cells(x, y), all_black(), drawing(CellShape::hexagon, 500));

    for (std::size_t line = 150; line < 300; ++line) {
        for (std::size_t column = 150; column < 300; ++column) CHECK(picture.at(column, line)[0] < 150);
    }
}

TEST_CASE("Voronoi squares: each pixel belongs to the nearest cell") {
    const auto cells = test::cells({0, 1.5}, {0, 0});

    const auto picture = draw_cells(cells, Output{}, drawing(CellShape::voronoi, 450));

    CHECK(picture.columns == 450);
    CHECK(picture.rows == 300);
    CHECK(picture.at(223, 150) == blue_cell);
    CHECK(picture.at(226, 150) == red_cell);
    CHECK(picture.at(0, 0) == blue_cell);
    CHECK(picture.at(449, 299) == red_cell);
    CHECK(count(picture, blue_cell) == std::size_t{225} * 300);
    CHECK(count(picture, white) == 0);
}

TEST_CASE("a later cell covers an earlier one") {
    const auto picture = draw_cells(test::cells({0, 0}, {0, 0}), Output{}, drawing(CellShape::circle, 50));

    CHECK(count(picture, blue_cell) == 0);
    CHECK(picture.at(25, 25) == red_cell);
}

TEST_CASE("polarity marks point along the polarity") {
    auto cells = test::cells({0, 4}, {0, 0});
    cells.polarity_x = {0.0, 0.0};
    cells.polarity_y = {1.0, 0.0};

    const auto plain = draw_cells(cells, Output{}, drawing(CellShape::circle, 600));
    const auto marked = draw_cells(cells, Output{}, drawing(CellShape::circle, 600, true));

    CHECK(marked.at(100, 50) == black);       // above the centre of the first cell
    CHECK(marked.at(100, 150) == blue_cell);  // below it
    CHECK(marked.at(500, 50) == red_cell);    // the second cell has no polarity
    CHECK(count(plain, black) == 0);
}

TEST_CASE("many small cells get a larger picture, absurd places none") {
    std::vector<double> x(1000);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = 2 * static_cast<double>(i);
    auto lost = test::cells({0, std::nan("")}, {0, 0});

    const auto wide = draw_cells(test::cells(x, std::vector<double>(1000)), Output{}, drawing(CellShape::circle, 800));
    const auto one = draw_cells(lost, Output{}, drawing(CellShape::circle, 10));
    const auto none = draw_cells(test::cells({}, {}), Output{}, drawing(CellShape::circle, 10));

    CHECK(wide.columns == 4000);
    CHECK(wide.rows == 4);
    CHECK(one.columns == 10);
    CHECK(one.at(5, 5) == blue_cell);
    CHECK(count(none, white) == 100);
    CHECK_THAT(test::error_of([&] { draw_cells(lost, {5, {}, {}}, {}); }), Contains("not among"));
}
