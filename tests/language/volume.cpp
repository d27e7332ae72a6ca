// Volumes in the language: what is understood, and what is refused with line and column.
#include "core/adjacency.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "language/error_case.hpp"
#include "language/parsed.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

const std::string volume_start = "define chemical U\ndefine chemical V\ncreate volume 7 5 3\n";

Volume volume_of(const std::string& text) { return std::get<Volume>(space_of(test::parsed(text))); }
std::string volume_error(const std::string& text) { return test::message_of(volume_start + text); }

}  // namespace

TEST_CASE("a volume has columns, rows, layers, a boundary and a stencil") {
    const Volume plain = volume_of(volume_start);
    CHECK(plain.columns == 7);
    CHECK(plain.rows == 5);
    CHECK(plain.layers == 3);
    CHECK(plain.boundary == Boundary::no_flux);
    CHECK(plain.stencil == Stencil::seven_point);
    const Volume torus = volume_of("define chemical U\ndefine stencil twenty-seven-point\ncreate volume 2 3 4 wrap\n");
    CHECK(torus.boundary == Boundary::wrap);
    CHECK(torus.stencil == Stencil::twenty_seven_point);
    CHECK(volume_of("define chemical U\ncreate volume 2 3 4 absorbing\n").boundary == Boundary::absorbing);
}

TEST_CASE("cells of a volume lie in layers of rows of columns, and starts know them") {
    const Snapshot state = initial_state(
        test::parsed("define chemical U floor none\ndefine field deep (100 * LAYER + Z)\nuse chemical U conc (deep + "
                     "10 * ROW + COLUMN)\n"
                     "create volume 4 3 2\nset cells where (LAYER == LAYERS - 1 and ROW == 0) chemical U conc 7\n"));
    CHECK(state.volume());
    CHECK(state.cells() == 24);
    CHECK(state.layers == 2);
    CHECK(state.conc[0][6] == 11.0);                     // layer 0, row 1, column 2: -1 + 10 + 2
    CHECK(state.conc[0][(1 * 3 + 2) * 4 + 3] == 124.0);  // layer 1, row 2, column 3: 101 + 20 + 3
    CHECK(state.conc[0][12] == 7.0);
}

TEST_CASE("rules in a volume read its layers and its third gradient") {
    const Experiment e =
        test::parsed(volume_start + "rule if LAYER < LAYERS react U by (gradient_z(V) + Z * laplacian(U))\n");
    CHECK(std::get<Compare>(e.rules[0].condition).left.quantity == Quantity::layer);
    CHECK(std::get<Compare>(e.rules[0].condition).right.quantity == Quantity::layers);
}

TEST_CASE("words of volumes may name chemicals and parameters, as they did before there were volumes") {
    const Experiment e = test::parsed(
        "define parameter LAYER 2\ndefine chemical Z\ncreate matrix 3 3\n"
        "rule always react Z by (LAYER - Z)\nrule if Z conc < LAYER set Z conc 1\n");
    CHECK(e.chemicals[0].name == "Z");
}

TEST_CASE("outputs say how a volume becomes a picture") {
    const Experiment e =
        test::parsed(volume_start + "output U slice x 6\noutput U maximum as m\noutput V transparent\noutput V as w\n");
    REQUIRE(e.outputs.size() == 4);
    CHECK(e.outputs[0].projection->kind == Projection::Kind::slice);
    CHECK(e.outputs[0].projection->axis == Axis::x);
    CHECK(e.outputs[0].projection->at == 6);
    CHECK(e.outputs[1].projection->kind == Projection::Kind::maximum);
    CHECK(e.outputs[2].projection->kind == Projection::Kind::transparent);
    CHECK_FALSE(e.outputs[3].projection.has_value());
}

TEST_CASE("what needs a plane is refused in a volume, with its line") {
    for (const std::string line :
         {"rule every 10 always expand columns 1", "rule always polarize U conc", "rule always divide",
          "rule always move 1", "rule always aggregate U V", "set cell 0 polarity 90", "texture size 20 20",
          "define stencil nine-point", "define stencil 3x3 0 1 0 1 -4 1 0 1 0",
          "define stencil blur 3x3 1 1 1 1 1 1 1 1 1", "use polarity 30", "define chemical W anisotropic"}) {
        INFO(line);
        CHECK_THAT(volume_error(line + "\n"), Contains("t.pex:4") && Contains("belongs to a plane"));
    }
}

TEST_CASE("what needs a volume is refused elsewhere") {
    for (const std::string line :
         {"define stencil seven-point", "output U maximum", "output U slice z 1", "rule if LAYER < 2 change U conc 1",
          "rule always react U by (gradient_z(V))", "rule always react U by (Z)"}) {
        INFO(line);
        CHECK_THAT(test::message_of(test::matrix + line + "\n"),
                   Contains("t.pex:4") && Contains("belongs to a volume"));
    }
}

TEST_CASE("a volume that means nothing is refused") {
    CHECK_THAT(test::message_of("define chemical U\ncreate volume 3 4\n"), Contains("the number of layers"));
    CHECK_THAT(test::message_of("define chemical U\ncreate volume 3 4 0\n"), Contains("the number of layers"));
    CHECK_THAT(test::message_of("define chemical U\ncreate volume 2000 2000 2000\n"), Contains("at most 2147483647"));
    CHECK_THAT(volume_error("create volume 3 3 3\n"), Contains("t.pex:4") && Contains("no other 'create'"));
    CHECK_THAT(volume_error("create cell 0 0\n"), Contains("t.pex:4") && Contains("no other 'create'"));
    CHECK_THAT(test::message_of(test::matrix + "create volume 3 3 3\n"), Contains("no other 'create'"));
    CHECK_THAT(volume_error("output U slice x 7\n"), Contains("slice 7; there are slices 0 to 6"));
    CHECK_THAT(volume_error("output U slice w 1\n"), Contains("x, y"));
    CHECK_THAT(volume_error("output U maximum slice z 1\n"), Contains("in one way"));
    CHECK_THAT(volume_error("output U transparent height\n"), Contains("one value through a colormap"));
}

TEST_CASE("volumes built by hand are checked, too") {
    Experiment e = test::parsed(volume_start);
    e.rules.push_back({});
    e.rules.back().action = Polarize{0};
    CHECK_THROWS_WITH(validate(e), Contains("belongs to a plane"));
    e.rules.clear();
    e.prepattern.emplace_back(CreateCell{});
    CHECK_THROWS_WITH(validate(e), Contains("holds all cells"));
    Experiment plane = test::parsed(test::matrix);
    plane.stencil = Stencil::seven_point;
    CHECK_THROWS_WITH(validate(plane), Contains("stencil of the plane"));
    plane.stencil = Stencil::five_point;
    plane.outputs[0].projection = Projection{};
    CHECK_THROWS_WITH(validate(plane), Contains("show a volume"));
}

TEST_CASE("neighbours of a volume's cells come layer by layer") {
    const LatticeAdjacency open = volume_adjacency({3, 2, 2, Boundary::no_flux, Stencil::seven_point});
    CHECK(std::vector(open.indices.begin(), open.indices.begin() + 3) == std::vector<std::uint32_t>{1, 3, 6});
    const LatticeAdjacency torus = volume_adjacency({3, 2, 2, Boundary::wrap, Stencil::seven_point});
    CHECK(std::vector(torus.indices.begin(), torus.indices.begin() + 6) ==
          std::vector<std::uint32_t>{6, 3, 2, 1, 3, 6});
    const LatticeAdjacency absorbing = volume_adjacency({3, 2, 2, Boundary::absorbing, Stencil::twenty_seven_point});
    CHECK(absorbing.count(0) == 26);
    double sum = 0.0;
    for (std::size_t i = 0; i < 26; ++i) sum += absorbing.weights[i];
    CHECK(sum == Approx(128.0 / 30));
}
