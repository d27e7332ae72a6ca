// What outputs of expressions draw, and where.
#include "io/drawn.hpp"
#include "core/prepattern.hpp"
#include "io/brush.hpp"
#include "io/results.hpp"
#include "language/parse.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace pelage;

namespace {

const std::string torus = "define chemical U limit none floor none\ncreate matrix 4 3 wrap at 1 2\n";

std::vector<double> drawn(const std::string& text, const std::string& expression, bool growing = false) {
    const Experiment experiment = parse_experiment(text + "output (" + expression + ")\n", "t.pex", "");
    Snapshot state = initial_state(experiment);
    state.iteration = 7;
    for (std::size_t i = 0; i < state.cells(); ++i) {
        state.conc[0][i] = static_cast<double>(i * i);
        state.birth[i] = static_cast<std::uint32_t>(i % 3);
        state.neighbours[i] = 8;
        for (auto& mapping : state.mappings) mapping[i] = -1.0 * static_cast<double>(i);
    }
    if (growing) std::swap(state.columns, state.rows);
    const Drawn values(experiment, experiment.outputs.at(0), 0, state);
    return {values.values().begin(), values.values().end()};
}

double at(const std::vector<double>& values, std::size_t column, std::size_t row) { return values[row * 4 + column]; }

}  // namespace

TEST_CASE("an output's expression reads all that a state holds") {
    const std::string text = torus + "define time_step 0.5\nrule always map U conc 0 1 to M 0 1\n";
    CHECK(drawn(text, "2 * U + diff(U)")[5] == 50.0);
    CHECK(drawn(text, "M")[5] == -5.0);
    CHECK(drawn(text, "AGE")[5] == 5.0);
    CHECK(drawn(text, "BIRTH")[5] == 2.0);
    CHECK(drawn(text, "NEIGHBORS")[5] == 8.0);
    CHECK(drawn(text, "ITERATION")[5] == 7.0);
    CHECK(drawn(text, "TIME")[5] == 3.5);
    CHECK(drawn(text, "X")[5] == 0.0);
    CHECK(drawn(text, "Y")[5] == 2.0);
    CHECK(drawn(text, "10 * ROW + COLUMN")[5] == 11.0);
    CHECK(drawn(text, "10 * ROWS + COLUMNS")[5] == 34.0);
    CHECK(drawn(text, "10 * ROWS + COLUMNS", true)[5] == 43.0);
    CHECK(drawn(text + "define field F (ROW * COLUMNS + COLUMN)\n", "F")[7] == 7.0);
    const std::vector<double> noise = drawn(text, "RANDOM");
    CHECK(noise == drawn(text, "RANDOM"));
    CHECK(noise[0] != noise[1]);
}

TEST_CASE("laplacian and gradients of pictures are those of rules") {
    // U is i squared in place i of a lattice of 4 x 3.
    const auto u = [](std::size_t column, std::size_t row) {
        return std::pow(static_cast<double>(row * 4 + column), 2);
    };
    const std::string five = "define stencil five-point\n";
    const auto text = [&](const std::string& edge) {
        return "define chemical U floor none\ncreate matrix 4 3 " + edge + "\n" + five;
    };
    CHECK(at(drawn(text("wrap"), "laplacian(U)"), 0, 0) == u(1, 0) + u(3, 0) + u(0, 1) + u(0, 2) - 4 * u(0, 0));
    CHECK(at(drawn(text("no-flux"), "laplacian(U)"), 0, 0) == u(1, 0) + u(0, 1) - 2 * u(0, 0));
    CHECK(at(drawn(text("absorbing"), "laplacian(U)"), 3, 2) == u(2, 2) + u(3, 1) - 4 * u(3, 2));
    CHECK(at(drawn(text("wrap"), "gradient_x(U)"), 3, 1) == (u(0, 1) - u(2, 1)) / 2);
    CHECK(at(drawn(text("no-flux"), "gradient_x(U)"), 3, 1) == (u(3, 1) - u(2, 1)) / 2);
    CHECK(at(drawn(text("absorbing"), "gradient_y(U)"), 1, 2) == (0 - u(1, 1)) / 2);
    CHECK(at(drawn(torus + "define stencil moore\n", "laplacian(U)"), 1, 1) ==
          u(0, 0) + u(1, 0) + u(2, 0) + u(0, 1) + u(2, 1) + u(0, 2) + u(1, 2) + u(2, 2) - 8 * u(1, 1));
}

TEST_CASE("red, green and blue from 0 to 1") {
    const std::vector<double> red{0.0, 1.0, 2.0, 0.5, std::nan("")};
    const std::vector<double> green{0.0, 0.25, -3.0, 0.5, 0.0};
    const std::vector<double> blue{0.0, 1.0, 1.0, 0.5, 0.0};
    const Brush brush(Output{}, {red, green, blue}, {});
    CHECK(brush(0) == Rgb{0, 0, 0});
    CHECK(brush(1) == Rgb{255, 64, 255});
    CHECK(brush(2) == Rgb{255, 0, 255});
    CHECK(brush(3) == Rgb{128, 128, 128});
    CHECK(brush(4) == magenta);
    CHECK(brush.deep(1) == DeepRgb{65535, 16384, 65535});
    CHECK(brush.deep(4) == DeepRgb{65535, 0, 65535});
}

TEST_CASE("pictures of expressions are named, and made of every kind of tissue") {
    const test::Folder folder;
    const std::string pictures =
        "output (U + 1)\noutput (U + 2) as second range 0 9\noutput rgb (U) (U) (U) as third\noutput rgb (1) (0) (0)\n"
        "output (U * X) height as relief\noutput (U) normal 2\n";
    const std::string world = GENERATE("create matrix 4 3\n", "create hex_grid 4 3\ntexture size 8 8\n",
                                       "create matrix 4 3\ntexture size 5 6\n");
    const Experiment experiment = parse_experiment("define chemical U\n" + world + pictures, "t.pex", "");
    ResultOptions options;
    options.formats = {Format::png};
    write_results(folder.path(), "final", initial_state(experiment), experiment, options);
    std::vector<std::string> wanted{"final.png", "final.second.png", "final.third.png", "final.rgb.png"};
    const bool texture = experiment.texture.has_value();
    if (texture)
        wanted.insert(wanted.end(), {"texture.png", "texture.relief.height.png", "texture.formula.normal.png"});
    if (world.starts_with("create matrix"))
        wanted.insert(wanted.end(), {"final.relief.height.png", "final.formula.normal.png"});
    std::ranges::sort(wanted);
    auto found = test::names_in(folder.path());
    std::ranges::sort(found);
    CHECK(std::vector<std::string>(found.begin(), found.end()) == wanted);
}
