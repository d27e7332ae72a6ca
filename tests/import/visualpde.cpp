// Presets of VisualPDE: each construct, and what it becomes.
#include "import/files.hpp"
#include "import/lz_text.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <cmath>

using namespace test;
using Catch::Matchers::Contains;

namespace {

struct PdeConstruct {
    std::string fields, expected;
};

std::string preset(const std::string& fields) {
    return R"p({"numSpecies": 2, "domainScale": "16", "spatialStep": "0.5", "dt": 0.01, "squareCanvas": true, "reactionStr_1": "0", "reactionStr_2": "0")p" +
           std::string(fields.empty() ? "" : ", ") + fields + "}";
}

}  // namespace

TEST_CASE("each construct of a preset becomes one of the language") {
    const std::vector<PdeConstruct> constructs{
        {R"p("dt": 0.2)p", "define parameter dt 0.2\n"},
        {R"p("domainScale": "20")p", "create matrix 40 40 wrap"},
        {R"p("dimension": "1")p", "create matrix 32 1 wrap"},
        {R"p("diffusionStr_1_1": "D", "kineticParams": "D = 3 in [1, 0.1, 5]; q = 4")p",
         "define parameter D 3 from 1 to 5\n"},
        {R"p("diffusionStr_1_1": "2")p", "diff (2 / (dx * dx))"},
        {R"p("diffusionStr_1_1": "1+0.5*sin(x)")p", "diff ((1 + 0.5 * sin((COLUMN + 0.5) * dx)) / (dx * dx))"},
        {R"p("reactionStr_1": "u^2*v - (a+b)*u", "kineticParams": "a = 0.037;b = a/2;")p",
         "react u by (u ^ 2 * v - (a + b) * u)"},
        {R"p("reactionStr_1": "b", "kineticParams": "b = a/2; a = 3")p",
         "define parameter a 3\ndefine parameter b (a / 2)\n"},
        {R"p("reactionStr_1": "f*u", "kineticParams": "f = x/L_x")p", "react u by ((COLUMN + 0.5) * dx / L_x * u)"},
        {R"p("reactionStr_1": "sin(t)+y+L+L_y+L_min+dx+dt+pi")p",
         "sin(TIME) + (ROW + 0.5) * dx + L + L_y + L_min + dx + dt + PI"},
        {R"p("reactionStr_1": "ind(u > 0.5 && v <= 1)*v")p", "(u > 0.5 and v <= 1) * v"},
        {R"p("reactionStr_1": "H(u-1)+H(u,2)")p", "smoothstep(-0.01, 0.01, u - 1) + smoothstep(-0.01, 0.01, u - 2)"},
        {R"p("reactionStr_1": "u_x*v_y")p", "gradient_x(u) / dx * (gradient_y(v) / dx)"},
        {R"p("dimension": "1", "reactionStr_1": "u_xx - u_xb")p", "laplacian(u) / (dx * dx) - difference_xb(u) / dx"},
        {R"p("reactionStr_1": "u_xx - v_yy")p",
         "define stencil difference_xx 3x3 0 0 0 1 -2 1 0 0 0\ndefine stencil difference_yy 3x3 0 1 0 0 -2 0 0 1 0\n"},
        {R"p("reactionStr_1": "u_yf2")p",
         "define stencil difference_yf2 5x5 0 0 -0.5 0 0 0 0 2 0 0 0 0 -1.5 0 0 0 0 0 0 0 0 0 0 0 0\n"},
        {R"p("boundaryConditions_1": "neumann", "diffusionStr_2_2": "0")p", "create matrix 32 32 no-flux"},
        {R"p("boundaryConditions_1": "neumann", "diffusionStr_2_2": "0", "reactionStr_1": "v_x")p",
         "create matrix 32 32 wrap"},
        {R"p("boundaryConditions_1": "combo", "comboStr_1": "Left: Ghost = 1", "diffusionStr_1_1": "2")p",
         "if(COLUMN == 0, 2 * ((1 - u) / dx) / dx, 0)"},
        {R"p("reactionStr_1": "-u^3 + u^4 + u^0.5 + tanh(u)")p", "-u ^ 3 + u ^ 4 + pow(u, 0.5) + tanh(u)"},
        {R"p("reactionStr_1": "max(u,0)+min(v,1)+mod(u,2)+abs(u)")p", "max(u, 0) + min(v, 1) + mod(u, 2) + abs(u)"},
        {R"p("initCond_1": "1+0.1*RAND")p", "use chemical u conc (1 + 0.1 * RANDOM)"},
        {R"p("initCond_1": "RANDN")p", "sqrt(-2 * log(1 - RANDOM)) * cos(2 * PI * RANDOM)"},
        {R"p("initCond_1": "Bump(L_x/2,L_y/2,3)")p", "exp(1 - 1 / (1 - "},
        {R"p("initCond_1": "t+3")p", "use chemical u conc 3"},
        {R"p("reactionStr_1": "WhiteNoise")p", "/ sqrt(dt * (dx * dx))"},
        {R"p("speciesNames": "T R", "reactionStr_1": "T*R")p", "react T by (T * R)"},
        {R"p("speciesNames": "X, u", "reactionStr_1": "X*u")p", "react X_ by (X_ * u)"},
        {R"p("boundaryConditions_1": "neumann", "boundaryConditions_2": "neumann")p", "create matrix 32 32 no-flux"},
        {R"p("boundaryConditions_1": "dirichlet", "dirichletStr_1": "2")p",
         "rule if (COLUMN == 0 or COLUMN == COLUMNS - 1 or ROW == 0 or ROW == ROWS - 1) set u conc (2)"},
        {R"p("boundaryConditions_1": "combo", "comboStr_1": "Left: Dirichlet = x; Right: Neumann = 3;", "dimension": "1", "diffusionStr_1_1": "2")p",
         "if(COLUMN == COLUMNS - 1, 2 * 3 / dx, 0)"},
        {R"p("boundaryConditions_1": "robin", "robinStr_1": "-u", "boundaryConditions_2": "neumann", "diffusionStr_1_1": "1")p",
         "if(ROW == 0, -u / dx, 0)"},
        {R"p("crossDiffusion": true, "diffusionStr_1_2": "-3")p", "-3 * laplacian(v) / (dx * dx)"},
        {R"p("crossDiffusion": true, "diffusionStr_1_2": "-u")p",
         "(-u * laplacian(v) + -1 * (gradient_x(u) * gradient_x(v) + gradient_y(u) * gradient_y(v))) / (dx * dx)"},
        {R"p("diffusionStr_1_1": "u^2")p", "2 * pow(u, 2 - 1)"},
        {R"p("crossDiffusion": true, "numAlgebraicSpecies": 1, "diffusionStr_2_2": "0", "diffusionStr_2_1": "1", "reactionStr_2": "u^3-u")p",
         "rule always set v conc (u ^ 3 - u + laplacian(u) / (dx * dx))"},
        {R"p("timescales": true, "timescale_1": "5", "reactionStr_1": "u")p", "react u by (u / 5)"},
        {R"p("domainViaIndicatorFun": true, "domainIndicatorFun": "x < 3", "boundaryConditions_1": "dirichlet")p",
         "rule if (not (COLUMN + 0.5) * dx < 3) set u conc (0)"},
        {R"p("autoPause": true, "autoPauseAt": 5)p", "stop at 500\n"},
        {R"p("whatToPlot": "v", "minColourValue": "0", "maxColourValue": "0.5")p", "output v range 0 0.5"},
        {R"p("views": [{"whatToPlot": "v"}])p", "output v "},
        {R"p("whatToPlot": "u^2+v")p", "output (u ^ 2 + v)"},
        {R"p("clearValueU": "7")p", "use chemical u conc 7"},
        {R"p("rV": "7", "cV": "5")p", "use chemical v conc 5"},
    };
    for (const PdeConstruct& one : constructs) {
        INFO(one.fields);
        CHECK_THAT(imported(preset(one.fields)).text, Contains(one.expected));
    }
}

TEST_CASE("what a preset asks for and cannot be had is refused, field by field") {
    const std::vector<PdeConstruct> constructs{
        {R"p("reactionStr_1": "I_T*u")p", "test.file: reactionStr_1: 'I_T' is an image"},
        {R"p("reactionStr_1": "foo")p", "'foo' is no species"},
        {R"p("reactionStr_1": "bar(u)")p", "'bar' is no function"},
        {R"p("reactionStr_1": "u(1-u)")p", "a product needs its '*'"},
        {R"p("reactionStr_1": "u_xxy")p", "'u_xxy' is a derivative"},
        {R"p("reactionStr_1": "u[x+dx,y]")p", "'u[...]'"},
        {R"p("reactionStr_1": "u +")p", "reactionStr_1: found the end"},
        {R"p("diffusionStr_1_1": "1;2")p", "diffusionStr_1_1"},
        {R"p("boundaryConditions_1": "weird")p", "'weird'"},
        {R"p("boundaryConditions_1": "combo", "comboStr_1": "Left: Mirror = 1")p", "'Mirror'"},
        {R"p("kineticParams": "a = b; b = a", "reactionStr_1": "a")p", "defined by itself"},
        {R"p("kineticParams": "rubbish")p", "no definition NAME = VALUE"},
        {R"p("numSpecies": 7)p", "must be 1, 2, 3 or 4"},
        {R"p("domainScale": "1e9")p", "from 1 to 8192"},
        {R"p("spatialStep": "0")p", "must be a number above 0"},
        {R"p("dt": "fast")p", "must be a number above 0"},
        {R"p("automataMode": true)p", "automata"},
    };
    for (const PdeConstruct& one : constructs) {
        INFO(one.fields);
        CHECK_THAT(refusal(preset(one.fields)), Contains(one.expected));
    }
    CHECK_THAT(refusal("{}"), Contains("holds no field of a preset"));
    CHECK_THAT(refusal(R"p({"preset": "GrayScott"})p"), Contains("only names a preset"));
    CHECK_THAT(refusal("[1, 2]"), Contains("neither XML, nor JSON"));
    CHECK_THAT(refusal("{\"a\": 1"), Contains("is no JSON"));
    CHECK_THAT(refusal("{\"a\":" + std::string(100'000, '[')), Contains("nested too deeply"));
    CHECK_THAT(refusal("  \n"), Contains("is empty"));
    CHECK_THAT(refusal("https://visualpde.com/sim/?preset=GrayScott"), Contains("without 'options='"));
}

TEST_CASE("what is done differently is noted, and stands in the experiment") {
    const auto made = imported(preset(
        R"p("timesteppingScheme": "RK4", "squareCanvas": false, "spatialStep": "0.3", "parent": "other", "boundaryConditions_2": "neumann")p"));
    CHECK(made.notes.size() == 5);
    for (const std::string& note : made.notes) CHECK_THAT(made.text, Contains("// NOTE: " + note));
}

TEST_CASE("a preset is the same numbers as its equations") {
    const auto made = imported(preset(
        R"p("reactionStr_1": "u*(1-u)*(u-a)", "diffusionStr_1_1": "D", "kineticParams": "a = 0.1; D = 0.3", "dimension": "1",
           "boundaryConditions_1": "dirichlet", "dirichletStr_1": "0.5", "initCond_1": "exp(-(x-8)^2)", "numSpecies": 1)p"));
    const auto state = run(made, 40);
    const std::size_t count = 32;
    std::vector<double> u(count);
    const auto fix = [&](std::vector<double>& values) { values.front() = values.back() = 0.5; };
    for (std::size_t i = 0; i < count; ++i) u[i] = std::exp(-std::pow((double(i) + 0.5) * 0.5 - 8, 2));
    fix(u);
    for (int step = 0; step < 40; ++step) {
        std::vector<double> next = u;
        for (std::size_t i = 1; i + 1 < count; ++i)
            next[i] += 0.01 * (0.3 / 0.25 * (u[i - 1] - 2 * u[i] + u[i + 1]) + u[i] * (1 - u[i]) * (u[i] - 0.1));
        fix(next);
        u = next;
    }
    for (std::size_t i = 0; i < count; ++i) CHECK(std::fabs(state.conc[0][i] - u[i]) < 1e-13);
}

TEST_CASE("entries of VisualPDE's own list need no quotes around their keys") {
    const auto text = [](const std::string& fields) {
        return "presets[\"Name\"] = {\n  numSpecies: 2, domainScale:\n \"16\",\n" + fields + "\n};\n";
    };
    const auto made =
        imported(text("  reactionStr_1: \"-u\", dt: 5e-3, squareCanvas: true,\n  views: [{ name: \"a: b, c\", "
                      "whatToPlot: \"v\", },],\n"));
    CHECK_THAT(made.text, Contains("react u by (-u)") && Contains("define parameter dt 0.005") && Contains("output v"));
    CHECK_THAT(refusal(text("  reactionStr_1: \"u, {v: 3}\",")), Contains("reactionStr_1"));
    CHECK_THAT(refusal(text("  reactionStr_1: \"-u\" dt: 3")), Contains("is no JSON"));
    CHECK_THAT(refusal(text("  parent: \"KellerSegel\"")), Contains("parent: the equations are those of the preset"));
}

TEST_CASE("compressed texts of addresses are read") {
    using pelage::imports::from_lz_text;
    CHECK(from_lz_text("N4IghiBcCMC+Q", 100) == R"p({"a":1})p");
    const std::string packed =
        "N4IgTgqiBcIK4CpEDcC0AKAhgagEYEokQAaEAEwilgEYSQBnAOxngAJk6yAXGABgDpqpANYtMrALysBvAM"
        "wB2ANy5J0-rwBsikAF8gA";
    const std::string text = R"p({"rU":"u*u*v-(a+b)*u","dUU":"1","sn":"u v","dt":0.1,"k":"a = 0.037;b = 0.06;"})p";
    CHECK(from_lz_text(packed, 100) == text);
    CHECK(from_lz_text(packed, 20) == std::nullopt);
    CHECK(from_lz_text("!!", 100) == std::nullopt);
    CHECK(from_lz_text("Q", 100) == "");
    const std::string expected = "react u by (u * u * v - (a + b) * u)";
    CHECK_THAT(imported("https://visualpde.com/sim/?options=" + packed + "&mini").text, Contains(expected));
    CHECK_THAT(imported(packed + "\n").text, Contains(expected));
    CHECK_THAT(imported("presets[\"x\"] = " + text + ";\n").text, Contains(expected));
}
