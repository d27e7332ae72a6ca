// Formulas of Ready: each construct, and what it becomes.
#include "import/files.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using Catch::Matchers::Contains;

namespace {

struct Construct {
    std::string formula, expected;
};

Pattern two_chemicals(const std::string& formula) {
    Pattern pattern;
    pattern.formula = formula;
    pattern.chemicals = 2;
    pattern.parameters = {{"timestep", "0.1"}, {"k", "0.5"}, {"D", "2"}};
    return pattern;
}

}  // namespace

TEST_CASE("each construct of a formula becomes one of the language") {
    const std::vector<Construct> constructs{
        {"delta_a = D * laplacian_a;", "use chemical a conc 0 diff D\n"},
        {"delta_a = laplacian_a * 0.25f / k + b;", "diff (0.25 / k)"},
        {"delta_a = -(D * laplacian_a);", "react a by (-(D * laplacian(a)))"},
        {"delta_a = D * laplacian_b;", "react a by (D * laplacian(b))"},
        {"delta_a = b * laplacian_a;", "react a by (b * laplacian(a))"},
        {"delta_a = D * laplacian_a - a*b*b + k*(1.0f-a);", "react a by (-(a * b * b) + k * (1 - a))"},
        {"float4 x = a * 2; delta_a = x - b;", "react a by (a * 2 - b)"},
        {"float x = 1, y = a; x += y; x *= 2; x -= b; x /= k; delta_a = x;", "react a by (((1 + a) * 2 - b) / k)"},
        {"delta_a = a > 0.5f ? 1.0f : -b;", "react a by (if(a > 0.5, 1, -b))"},
        {"if (a < b && !(a == 0.0f)) { delta_a = 1; } else delta_a = k;", "(if(a < b and not a == 0, 1, k))"},
        {"if (a > 1 || b >= 2) delta_a = 3;", "react a by (if(a > 1 or b >= 2, 3, 0))"},
        {"a = k; delta_b = a;", "rule always set a conc (k)"},
        {"a = clamp(a, 0.0f, 1.0f); delta_a = b;", "set a conc (clamp(a, 0, 1) + timestep * b)"},
        {"delta_a = x_pos + y_pos;", "COLUMN / COLUMNS + ROW / ROWS"},
        {"delta_a = x_gradient_b * y_gradient_a;", "gradient_x(b) * gradient_y(a)"},
        {"delta_a = gradient_mag_squared_a;", "gradient_x(a) * gradient_x(a) + gradient_y(a) * gradient_y(a)"},
        {"delta_a = fmin(fmax(a, 0), 1) + fabs(b);", "min(max(a, 0), 1) + abs(b)"},
        {"delta_a = pow(a, 2.0f) + pow(b, k);", "a ^ 2 + pow(b, k)"},
        {"delta_a = select((float4)(0.0f), (float4)1.0f, isgreater(a, b));", "if(a > b, 1, 0)"},
        {"delta_a = convert_float4(a > b);", "-(a > b)"},
        {"delta_a = mad(a, b, k) + native_exp(-a) + rsqrt(b);", "a * b + k + exp(-a) + 1 / sqrt(b)"},
        {"delta_a = fmod(a, b);", "a - b * if(a / b < 0, ceil(a / b), floor(a / b))"},
        {"delta_a = sign(a) + trunc(b);", "if(a > 0, 1, if(a < 0, -1, 0)) + if(b < 0, ceil(b), floor(b))"},
        {"delta_a = sin(M_PI_F * a); // a comment\n/* another */", "sin(PI * a)"},
        {"int n = a * 3; delta_a = n;", "if(a * 3 < 0, ceil(a * 3), floor(a * 3))"},
        {"delta_a = a - (b - k) - a / (b / k) * (a * b);", "a - (b - k) - a / (b / k) * (a * b)"},
        {"delta_a = step(0.5f, a) + mix(a, b, k) + smoothstep(0.0f, 1.0f, b);",
         "step(0.5, a) + mix(a, b, k) + smoothstep(0, 1, b)"},
        {"const float4 c4 = { 1.0f };", ""},
    };
    for (const Construct& one : constructs) {
        INFO(one.formula);
        if (one.expected.empty()) {
            CHECK_FALSE(refusal(text_of(two_chemicals(one.formula))).empty());
        } else {
            CHECK_THAT(imported(two_chemicals(one.formula)).text, Contains(one.expected));
        }
    }
}

TEST_CASE("what cannot be carried over is refused, construct by construct, with file and line") {
    const std::vector<Construct> constructs{
        {"delta_a = a_n4w;", "test.file:9: 'a_n4w' is no keyword that is known here, or the value of a cell that is"},
        {"\ndelta_a = quadlaplacian_a;", "test.file:10: 'quadlaplacian_a' is no chemical, parameter or keyword"},
        {"delta_a = foo(a, b);", "the function 'foo' of 2 values"},
        {"delta_a = q;", "'q' is no chemical"},
        {"for (int i = 0; i < 3; i++) delta_a += a;", "'for'"},
        {"delta_a = a.x;", "'.x', a part of a vector"},
        {"delta_a = a_in[3];", "'a_in[...]'"},
        {"a.x = 1;", "'a.x'"},
        {"delta_a = 5 % 3;", "'%'"},
        {"delta_a = (float4)(0.0f, 1.0f, 2.0f, 3.0f);", "a vector whose parts are different"},
        {"#define Q 3\ndelta_a = Q;", "preprocessor"},
        {"q = 3;", "'q' is given a value"},
        {"delta_a = ;", "found ';' where a value must stand"},
        {"delta_a = 1", "found the end where ';' must stand"},
        {"{ delta_a = 1;", "'{' is not closed"},
        {"delta_a = 1e999;", "too large"},
        {"delta_a = \"x\";", "found '\"'"},
    };
    for (const Construct& one : constructs) {
        INFO(one.formula);
        CHECK_THAT(refusal(text_of(two_chemicals(one.formula))), Contains(one.expected));
    }
    const std::string both = refusal(text_of(two_chemicals("delta_a = a_n9 + b_s12 + a_n9;")));
    CHECK_THAT(both, Contains("'a_n9'") && Contains("'b_s12'"));
}

TEST_CASE("formulas that grow without bound are refused in a sentence") {
    std::string doubling = "float x = a;", signs;
    for (int i = 0; i < 40'000; ++i) signs += "- ";
    for (int i = 0; i < 200; ++i) doubling += "x = x * x;";
    CHECK_THAT(refusal(text_of(two_chemicals(doubling + "delta_a = x;"))), Contains("4000 parts"));
    std::string deep = "float x = a;";
    for (int i = 0; i < 2000; ++i) deep += "x = x + 1;";
    CHECK_THAT(refusal(text_of(two_chemicals(deep + "delta_a = x;"))), Contains("levels deep"));
    CHECK_THAT(refusal(text_of(two_chemicals("delta_a = " + std::string(50'000, '(')))), Contains("too deeply"));
    CHECK_THAT(refusal(text_of(two_chemicals("delta_a = " + signs + "1;"))), Contains("signs"));
    CHECK_THAT(refusal(text_of(two_chemicals(std::string(50'000, '{')))), Contains("too deeply"));
}

TEST_CASE("names that mean something here get another name, and that is said") {
    Pattern pattern = two_chemicals("delta_a = AGE * a + step * b + PI;");
    pattern.parameters = {{"timestep", "0.1"}, {"AGE", "3"}, {"step", "4"}, {"PI", "3"}, {"not used", "1"}};
    const auto made = imported(pattern);
    CHECK_THAT(made.text, Contains("react a by (AGE_ * a + step_ * b + PI_)") && Contains("define parameter AGE_ 3"));
    CHECK_THAT(made.text, !Contains("define parameter not"));
    CHECK(made.notes.size() == 4);
}

TEST_CASE("dx scales slopes and the Laplacian, and in one dimension neighbours are known") {
    Pattern pattern = two_chemicals("delta_a = D * laplacian_a + x_gradient_b;");
    pattern.parameters.emplace_back("dx", "0.5");
    CHECK_THAT(imported(pattern).text, Contains("diff (D / (dx * dx))") && Contains("gradient_x(b) / dx"));

    Pattern line = two_chemicals("delta_a = a_e - 2 * a + a_w; delta_b = b_e;");
    line.extent = "0 15 0 0 0 0";
    line.generator =
        "<initial_pattern_generator>" + overlay("a", "<constant value=\"1\"/><pixel x=\"5\" y=\"0\" z=\"0\"/>") +
        overlay("b", "<constant value=\"1\"/><pixel x=\"5\" y=\"0\" z=\"0\"/>") + "</initial_pattern_generator>";
    const auto made = imported(line);
    CHECK_THAT(made.text, Contains("create matrix 16 1 wrap"));
    const auto state = run(made, 1);
    CHECK(state.conc[0][4] == Approx(0.1));
    CHECK(state.conc[0][5] == Approx(0.8));
    CHECK(state.conc[0][6] == Approx(0.1));
    CHECK(state.conc[1][4] == Approx(0.1));
    CHECK(state.conc[1][5] == Approx(1.0));
    CHECK(state.conc[1][6] == Approx(0.0).margin(1e-15));
}

namespace {

std::string at_place(double x, double y) { return fmt::format("<point3D x=\"{}\" y=\"{}\" z=\"0\"/>", x, y); }

// What a pattern of 16 x 16 cells, with values that are different everywhere, makes of them in one step.
std::vector<double> made_of(const std::string& formula, bool wrap) {
    Pattern pattern = two_chemicals(formula);
    pattern.extent = "0 15 0 15 0 0";
    pattern.rule += wrap ? " wrap=\"1\"" : " wrap=\"0\"";
    pattern.parameters.emplace_back("dx", "0.5");
    pattern.generator = "<initial_pattern_generator>" +
                        overlay("a", "<linear_gradient val1=\"0\" val2=\"1\">" + at_place(0, 0) + at_place(1, 0.3) +
                                         "</linear_gradient><everywhere/>") +
                        overlay("a", "<add/><sine amplitude=\"1\" phase=\"0.3\">" + at_place(0, 0) + at_place(.4, .7) +
                                         "</sine><everywhere/>") +
                        "</initial_pattern_generator>";
    return run(imported(pattern), 1).conc[1];
}

}  // namespace

TEST_CASE("stencils of Ready's and cells around are those of its definition, at every edge") {
    for (const bool wrap : {true, false}) {
        const std::vector<double> a = made_of("b = a;", wrap);
        const auto at = [&](int column, int row) {
            const auto placed = [&](int place) { return wrap ? (place + 16) % 16 : std::clamp(place, 0, 15); };
            return a[static_cast<std::size_t>(16 * placed(row) + placed(column))];
        };
        using Sum = std::function<double(int, int)>;
        const Sum nine = [&](int x, int y) {
            return (at(x - 1, y - 1) + at(x + 1, y - 1) + at(x - 1, y + 1) + at(x + 1, y + 1) +
                    4 * (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1)) - 20 * at(x, y)) /
                   6;
        };
        const std::vector<std::pair<std::string, Sum>> all{
            {"(float4)(a_w.w - a_nw.w + 2 * a.y, a.x - a_n.x + 2 * a.z, a.y - a_n.y + 2 * a.w, a.z - a_n.z + 2 * "
             "a_e.x)",
             [&](int x, int y) { return at(x - 1, y) - at(x - 1, y - 1) + 2 * at(x + 1, y); }},
            {"sobel_ne_a",
             [&](int x, int y) {
                 return 2 * at(x + 1, y + 1) + at(x, y + 1) + at(x + 1, y) - at(x - 1, y) - at(x, y - 1) -
                        2 * at(x - 1, y - 1);
             }},
            {"a_n - a_se2 + a_w3", [&](int x, int y) { return at(x, y + 1) - at(x + 2, y - 1) + at(x - 3, y); }},
            {"sobelN_a - sobelSW_a",
             [&](int x, int y) {
                 return at(x - 1, y + 1) + 2 * at(x, y + 1) + at(x + 1, y + 1) - at(x - 1, y - 1) - 2 * at(x, y - 1) -
                        at(x + 1, y - 1) -
                        (2 * at(x - 1, y - 1) + at(x - 1, y) + at(x, y - 1) - at(x + 1, y) - at(x, y + 1) -
                         2 * at(x + 1, y + 1));
             }},
            {"x_deriv3_a",
             [&](int x, int y) {
                 return (at(x + 2, y) - 2 * at(x + 1, y) + 2 * at(x - 1, y) - at(x - 2, y)) / (2 * 0.125);
             }},
            {"0.5 * a * laplacian_a", [&](int x, int y) { return 0.5 * at(x, y) * nine(x, y) / 0.25; }},
            {"y_gradient_a + x_gradient_a",
             [&](int x, int y) { return at(x, y + 1) - at(x, y - 1) + at(x + 1, y) - at(x - 1, y); }},
            {"bilaplacian_a", [&](int x, int y) {
                 double sum = 36 * at(x, y);
                 for (const int side : {-1, 1}) {
                     sum += -10 * (at(x + side, y) + at(x, y + side)) + at(x + 2 * side, y) + at(x, y + 2 * side);
                     for (const int up : {-1, 1})
                         sum += -2 * at(x + side, y + up) + at(x + 2 * side, y + up) + at(x + side, y + 2 * up);
                 }
                 return sum / 3 / 0.0625;
             }}};
        for (const auto& [formula, expected] : all) {
            INFO(formula << (wrap ? ", a torus" : ", open"));
            const std::vector<double> found = made_of("b = " + formula + ";", wrap);
            double worst = 0.0;
            for (int y = 0; y < 16; ++y) {
                for (int x = 0; x < 16; ++x)
                    worst = std::max(worst, std::fabs(found[static_cast<std::size_t>(16 * y + x)] - expected(x, y)));
            }
            CHECK(worst < 1e-11);
        }
    }
}

TEST_CASE("other kinds of rule and image are refused by their name") {
    Pattern kernel;
    kernel.rule = "type=\"kernel\" name=\"x\"";
    CHECK_THAT(refusal(text_of(kernel)), Contains("OpenCL kernel"));
    Pattern cube;
    cube.extent = "0 7 0 7 0 7";
    CHECK_THAT(refusal(text_of(cube)), Contains("three dimensions, 8 x 8 x 8"));
    Pattern unknown;
    unknown.rule = "type=\"inbuilt\" name=\"x\"";
    CHECK_THAT(refusal(text_of(unknown)), Contains("inbuilt rule 'x' is not known"));
    CHECK_THAT(refusal("<VTKFile type=\"ImageData\"><ImageData/></VTKFile>"), Contains("no element RD"));
    CHECK_THAT(refusal("<VTKFile type=\"UnstructuredGrid\"><RD><rule/></RD><UnstructuredGrid/></VTKFile>"),
               Contains("mesh"));
    CHECK_THAT(refusal("<svg/>"), Contains("is no file of VTK"));
    Pattern still;
    still.parameters = {{"timestep", "0"}};
    CHECK_THAT(refusal(text_of(still)), Contains("time step must be above 0"));
    Pattern wordy;
    wordy.parameters = {{"timestep", "fast"}};
    CHECK_THAT(refusal(text_of(wordy)), Contains("test.file:5") && Contains("'fast'"));
}

TEST_CASE("an imported Gray-Scott is the same numbers as its equations") {
    const bool wrap = GENERATE(true, false);
    Pattern pattern;
    pattern.chemicals = 2;
    pattern.rule = std::string("type=\"formula\" name=\"Gray-Scott\" wrap=\"") + (wrap ? "1\"" : "0\"");
    pattern.parameters = {{"timestep", "0.9"}, {"D_a", "0.082"}, {"D_b", "0.041"}, {"k", "0.06"}, {"F", "0.035"}};
    pattern.formula =
        "delta_a = D_a * laplacian_a - a*b*b + F*(1.0f-a);\ndelta_b = D_b * laplacian_b + a*b*b - (F+k)*b;";
    pattern.extent = "0 11 0 8 0 0";
    pattern.generator = "<initial_pattern_generator>" + overlay("a", "<constant value=\"1\"/><everywhere/>") +
                        overlay("b",
                                "<constant value=\"0.5\"/><rectangle><point3D x=\"0\" y=\"0.3\" z=\"0\"/>"
                                "<point3D x=\"0.4\" y=\"0.7\" z=\"1\"/></rectangle>") +
                        "</initial_pattern_generator>";
    const auto state = run(imported(pattern), 50);

    const long columns = 12, rows = 9;
    std::vector<double> a(columns * rows, 1.0), b(columns * rows, 0.0);
    for (long y = 0; y < rows; ++y) {
        for (long x = 0; x < columns; ++x) {
            const double u = double(x) / columns, v = double(y) / rows;
            if (u <= 0.4 && v >= 0.3 && v <= 0.7) b[static_cast<std::size_t>(y * columns + x)] = 0.5;
        }
    }
    for (int step = 0; step < 50; ++step) {
        const auto laplacian = [&](const std::vector<double>& c, long x, long y) {
            const auto at = [&](long i, long j) {
                i = wrap ? (i + columns) % columns : std::clamp(i, 0L, columns - 1);
                j = wrap ? (j + rows) % rows : std::clamp(j, 0L, rows - 1);
                return c[static_cast<std::size_t>(j * columns + i)];
            };
            return (4 * (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1)) + at(x - 1, y - 1) +
                    at(x + 1, y - 1) + at(x - 1, y + 1) + at(x + 1, y + 1) - 20 * at(x, y)) /
                   6;
        };
        std::vector<double> next_a = a, next_b = b;
        for (long y = 0; y < rows; ++y) {
            for (long x = 0; x < columns; ++x) {
                const auto i = static_cast<std::size_t>(y * columns + x);
                const double uvv = a[i] * b[i] * b[i];
                next_a[i] += 0.9 * (0.082 * laplacian(a, x, y) - uvv + 0.035 * (1 - a[i]));
                next_b[i] += 0.9 * (0.041 * laplacian(b, x, y) + uvv - (0.035 + 0.06) * b[i]);
            }
        }
        a = next_a;
        b = next_b;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        INFO("cell " << i);
        CHECK(std::fabs(state.conc[0][i] - a[i]) < 1e-13);
        CHECK(std::fabs(state.conc[1][i] - b[i]) < 1e-13);
    }
}
