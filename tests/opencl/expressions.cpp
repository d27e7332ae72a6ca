// Expressions: fields, formulas, conditions, laplacians and gradients end in the reference's bits on every path.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "opencl/rules/emit_rules.hpp"
#include "reference/backend.hpp"
#include "support/form.hpp"
#include "verify/compare.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace pelage;

namespace {

void check_equal(const std::string& text, const OpenclOptions& options, std::uint64_t first = 0) {
    INFO(text);
    const Experiment experiment = parse_experiment(text, "expressions.pex", ".");
    Snapshot initial = initial_state(experiment, options.precision);
    initial.iteration = first;
    const auto expected = reference_backend(options.precision)->make_tissue(experiment, initial);
    const auto found = opencl_backend(options)->make_tissue(experiment, initial);
    for (const std::uint64_t steps : {1, 2, 9, 12}) {
        expected->advance(steps);
        found->advance(steps);
        INFO("after iteration " << expected->iteration());
        REQUIRE(verify::differences(expected->read(), found->read()).empty());
    }
}

const std::string chemicals =
    "define parameter far 11\ndefine chemical U limit 9 floor -9\ndefine chemical V limit 9 floor -9\n"
    "define chemical W limit 9 floor -9\ndefine time_step 0.05\n";
const std::string starts =
    "use chemical U conc (2 + sin(X / 7) * cos(Y / 5)) diff 0.5\nuse chemical V conc (RANDOM) diff (0.2 + 0.1 * "
    "RANDOM)\n"
    "use chemical W conc 1 dev 0.5\n";
const std::string lattice_fields =
    "define field hill (exp(-(X ^ 2 + Y ^ 2) / far))\ndefine field noise (RANDOM - 0.5)\n";
const std::string of_both =
    "rule always react U by (U - U ^ 3 / 3 - V + 0.1 * sin(TIME)) V by (0.08 * (U + 0.7 - 0.8 * V))\n"
    "rule if (U > V and not W > 1.2 or AGE == 3) change W conc (0.1 * tanh(U * V) + atan2(U, V) / 40)\n"
    "rule probability (0.5 * sigmoid(U)) set W conc (if(RANDOM < 0.5, min(U, 2), max(V, diff(V))))\n"
    "rule always map (hypot(U, V)) 0 4 to M 0.5 1\nrule if (U + M) in (M - 1) (M + 1) change V conc (0.01 * M)\n"
    "rule every 2 if (mod(ITERATION, 4) == 2) change U conc (-0.02 * log(2 + U ^ 2)) dev 0.01\n"
    "rule always react W by (pow(2 + sin(W), 1.5) - 3)\n";

}  // namespace

TEST_CASE("weights of one's own: an upwind stencil carries a pattern along, a cell an iteration") {
    const auto carried = [](const std::string& weights, Backend& backend) {
        const Experiment experiment =
            parse_experiment("define chemical U\ndefine stencil 3x3 " + weights +
                                 "\nuse chemical U conc (floor(100 * RANDOM)) diff 1\ncreate matrix 7 5 wrap\n",
                             "wind.pex", "");
        const auto tissue = backend.make_tissue(experiment, initial_state(experiment));
        tissue->advance(3);
        return std::pair(initial_state(experiment).conc[0], tissue->read().conc[0]);
    };
    for (const bool device : {false, true}) {
        const auto backend = device ? opencl_backend({}) : reference_backend(Precision::single_);
        const auto [before, right] = carried("0 0 0 1 -1 0 0 0 0", *backend);
        const auto down = carried("0 1 0 0 -1 0 0 0 0", *backend).second;
        for (std::size_t row = 0; row < 5; ++row) {
            for (std::size_t column = 0; column < 7; ++column) {
                CHECK(right[row * 7 + column] == before[row * 7 + (column + 4) % 7]);
                CHECK(down[row * 7 + column] == before[(row + 3) % 5 * 7 + column]);
            }
        }
    }
}

TEST_CASE("Expressions on a matrix have the reference's bits on every path") {
    OpenclOptions options;
    options.path = GENERATE(Path::step, Path::shared, Path::streamed, Path::tiled);
    options.precision = options.path == Path::shared ? Precision::double_ : Precision::single_;
    check_equal(chemicals + lattice_fields + starts + "create matrix 37 23 no-flux\n" + of_both +
                    "rule if (hill > 0.5) react U by (-hill * (U + noise)) V by (0.01 * COLUMN / COLUMNS * ROW)\n",
                options);
}

TEST_CASE("Laplacians and gradients in expressions have the reference's bits on every path and at every edge") {
    const std::pair<Path, std::string> kinds[] = {{Path::step, "absorbing"},  {Path::step, "wrap"},
                                                  {Path::shared, "no-flux"},  {Path::streamed, "no-flux"},
                                                  {Path::streamed, "wrap"},   {Path::streamed, "absorbing"},
                                                  {Path::tiled, "absorbing"}, {Path::tiled, "no-flux"}};
    // What pairs of path and edge remain is in the generated checks of `pelage verify`, too.
    const auto& [path, boundary] =
        kinds[GENERATE(filter([](int i) { return test::long_form() || i % 2 == 1; }, range(0, 8)))];
    OpenclOptions options;
    options.path = path;
    const std::string stencil = boundary == "wrap" ? "five-point" : boundary == "absorbing" ? "sims" : "nine-point";
    check_equal("define stencil " + stencil + "\n" + chemicals + starts + "create matrix 37 23 " + boundary +
                    "\nrule always set W conc (laplacian(U) - 0.5 * U)\n"
                    "rule always react U by (0.3 * laplacian(W) - U * gradient_x(V) + gradient_y(U) * 0.1)\n"
                    "rule if (gradient_x(V) ^ 2 + gradient_y(V) ^ 2 > 0.01) change V conc (-0.01 * laplacian(V))\n",
                options);
}

namespace {

// 25 or 49 weights, all different and some of them 0; `balance`: they add up to 0.
std::string weights(std::size_t count, bool balance) {
    std::string text;
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        double weight = i % 5 == 3 && !balance ? 0.0 : static_cast<double>(1 + i * 7 % 29) / 512;
        if (balance && i == count / 2) weight = 0.0;
        sum += weight;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double weight = balance && i == count / 2 ? -sum
                              : i % 5 == 3 && !balance  ? 0.0
                                                        : static_cast<double>(1 + i * 7 % 29) / 512;
        text += fmt::format(" {}", weight);
    }
    return text;
}

}  // namespace

TEST_CASE("Stencils of five by five cells, and those with names, have the reference's bits at every edge") {
    struct Kind {
        Path path;
        std::string boundary;
        std::size_t columns, rows, width;
        Precision precision;
    };
    const std::vector<Kind> kinds{{Path::step, "absorbing", 37, 23, 0, Precision::single_},
                                  {Path::step, "wrap", 1, 3, 0, Precision::single_},
                                  {Path::step, "no-flux", 2, 1, 1, Precision::double_},
                                  {Path::shared, "wrap", 37, 23, 0, Precision::single_},
                                  {Path::shared, "no-flux", 17, 31, 1, Precision::single_},
                                  {Path::shared, "absorbing", 5, 4, 0, Precision::double_},
                                  {Path::streamed, "no-flux", 37, 23, 0, Precision::single_},
                                  {Path::tiled, "wrap", 18, 9, 0, Precision::single_}};
    const Kind& kind = kinds[GENERATE(
        filter([](std::size_t i) { return test::long_form() || i % 3 != 0; }, range<std::size_t>(0, 8)))];
    OpenclOptions options;
    options.path = kind.path;
    options.precision = kind.precision;
    options.width = kind.width;
    check_equal("define stencil 5x5" + weights(25, true) + "\ndefine stencil broad 7x7" + weights(49, false) +
                    "\ndefine stencil lean 3x3 0 0 0 -0.5 0.125 0.75 0 1 0\n" + chemicals + starts +
                    fmt::format("create matrix {} {} {}\n", kind.columns, kind.rows, kind.boundary) +
                    "rule always react U by (0.3 * laplacian(W) + 0.1 * broad(V) - lean(U)) V by (0.2 * lean(V) - V)\n"
                    "rule if (broad(U) > 1) set W conc (broad(V) - lean(U) + gradient_x(U) - gradient_y(V))\n"
                    "rule every 3 always polarize U conc\n"
                    "rule if NEIGHBORS > 11 change W conc (0.01 * NEIGHBORS)\n",
                options);
}

TEST_CASE("a stencil with a name takes what its weights say, and Laplacians of higher order are of higher order") {
    // In a torus cos(k x) is an eigenfunction: (-cos 2k + 16 cos k - 15) / 6 of the fourth-order five by five cross.
    const Experiment experiment = parse_experiment(
        "define chemical U floor none\ndefine chemical V floor none\n"
        "define stencil cross 5x5 0 0 -1 0 0 0 0 16 0 0 -1 16 -60 16 -1 0 0 16 0 0 0 0 -1 0 0\n"
        "define stencil right 3x3 0 0 0 0 0 1 0 0 0\n"
        "use chemical U conc (cos(2 * PI * COLUMN / 16))\ncreate matrix 16 4 wrap\n"
        "rule always set V conc (cross(U) / 12)\nrule always set U conc (right(U))\nstop at 1\n",
        "cross.pex", ".");
    OpenclOptions options;
    options.precision = Precision::double_;
    const auto tissue = opencl_backend(options)->make_tissue(experiment, initial_state(experiment, options.precision));
    tissue->advance(1);
    const Snapshot state = tissue->read();
    const double k = std::acos(-1.0) / 8, eigenvalue = (-std::cos(2 * k) + 16 * std::cos(k) - 15) / 6;
    CHECK(eigenvalue == Approx(-k * k).epsilon(5e-4));
    for (std::size_t column = 0; column < 16; ++column) {
        CHECK(state.conc[1][column] == Approx(eigenvalue * std::cos(k * static_cast<double>(column))).margin(1e-12));
        CHECK(state.conc[0][column] == Approx(std::cos(k * static_cast<double>(column + 1))).margin(1e-12));
    }
}

TEST_CASE("What is the same for all cells in an iteration is computed before the loops over cells") {
    const Experiment experiment = parse_experiment(
        "define chemical U\ndefine chemical V\nuse chemical U conc 1\nuse chemical V conc 1\ncreate matrix 4 4\n"
        "rule if (sin(ITERATION) > 0) change U conc (0.03 * cos(TIME / 100) + exp(V) * tan(ITERATION))\n",
        "course.pex", ".");
    const RuleText text = emit_rules(experiment, {true}, Precision::single_);
    for (const char* own : {"pelage_sin", "pelage_cos", "pelage_tan"}) {
        CHECK_THAT(text.shared, Catch::Contains(own));
        CHECK_THAT(text.rules, !Catch::Contains(own));
    }
    CHECK_THAT(text.rules, Catch::Contains("pelage_exp"));
    CHECK_THAT(text.shared, !Catch::Contains("pelage_exp"));
}

TEST_CASE("Expressions on a published grid and on free cells have the reference's bits") {
    OpenclOptions options;
    check_equal(
        chemicals + starts + "create sqr_grid 19 14\n" + of_both + "rule always set W conc (0.1 * laplacian(U))\n",
        options);
    check_equal(chemicals + "define field hill (exp(-(X ^ 2 + Y ^ 2) / far))\n" + starts + "create hex_circle 5\n" +
                    of_both + "rule if (hill > 0.3) move (0.02 * hill)\n",
                options);
}

TEST_CASE("Expressions follow a growing matrix and phases") {
    OpenclOptions options;
    options.path = GENERATE(Path::shared, Path::streamed);
    check_equal(chemicals + lattice_fields + starts +
                    "create matrix 21 13\nrule always react U by (hill - 0.1 * U + noise) V by (0.1 * sin(X) * U)\n"
                    "rule every 5 offset 2 always expand columns 1 rows 1\nphase \"a\" 8\n"
                    "rule always change V conc (0.001 * TIME)\nphase \"b\" 40\ndefine time_step 0.025\n"
                    "rule always change V conc (0.002 * sin(TIME))\n",
                options);
}
