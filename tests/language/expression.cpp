// Expressions in parentheses: what they mean, and each malformed one with the whole message it must give.
#include "core/fields.hpp"
#include "core/prepattern.hpp"
#include "core/scene.hpp"
#include "language/error_case.hpp"
#include "language/parsed.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <variant>

using namespace pelage;
using namespace test;

namespace {

// The number that the expression is; U stands for 3 and V for -2.
double value_of(const std::string& expression) {
    const Experiment e = parsed(
        "define chemical U floor none\ndefine chemical V floor none\ndefine chemical W floor none\n"
        "define parameter half 0.5\nuse chemical U conc 3\nuse chemical V conc -2\nuse chemical W conc " +
        expression + "\ncreate sqr_grid 1 1\n");
    return initial_state(e, Precision::double_).conc[2][0];
}

Operand amount(const std::string& text) { return action_on_grid<Change>("rule always change U conc " + text).amount; }

}  // namespace

TEST_CASE("expressions have the precedence of C, and powers bind tightest, to the right") {
    const std::pair<const char*, double> all[] = {
        {"(1 + 2 * 3)", 7},
        {"((1 + 2) * 3)", 9},
        {"(2 * U ^ 2)", 18},
        {"(-U ^ 2)", -9},
        {"(2 ^ -1)", 0.5},
        {"(2 ^ 3 ^ 2)", 512},
        {"(8 - 3 - 2)", 3},
        {"(8 / 4 / 2)", 1},
        {"(U - -V)", 1},
        {"(- -U)", 3},
        {"(U*V)", -6},
        {"(U ^ 2 + V ^ 3 + V ^ 4)", 9 - 8 + 16},
        {"(half * U)", 1.5},
        {"(PI)", std::numbers::pi},
        {"(U > V)", 1},
        {"(U < V)", 0},
        {"(1 + (U >= 3))", 2},
        {"(U == 3 and V == -2)", 1},
        {"(U == 3 and V == 2)", 0},
        {"(U == 1 or V == -2)", 1},
        {"(not U == 3)", 0},
        {"(not U == 1 and V != 0)", 1},
        {"(0 or 1 and 0)", 0},
        {"(if(U > 2, 10, 20))", 10},
        {"(if(V, 10, 20))", 10},
        {"(if(0, 10, 20))", 20},
        {"(max(U, V) + min(U, V))", 1},
        {"(clamp(U, 0, 1) + abs(V))", 3},
        {"(mod(-1, 3))", 2},
        {"(mix(U, V, half))", 0.5},
        {"(step(2, U))", 1},
        {"(round(2.5) + floor(-0.5) + ceil(0.5))", 3},
        {"(sqrt(16) + exp(0))", 5},
        {"(1e3 + .5)", 1000.5},
        {"(conc(U))", 3},
        {"(COLUMN + ROW + COLUMNS + ROWS)", 2},
    };
    for (const auto& [text, value] : all) {
        INFO(text);
        CHECK(value_of(text) == value);
    }
}

TEST_CASE("what is made of numbers alone is a number, and a name alone is the name") {
    CHECK(amount("(2 * 3 + 1)") == Operand::number(7));
    CHECK(amount("(U)") == Operand::concentration(0));
    CHECK(amount("(diff(V))") == Operand::rate(1));
    CHECK(amount("(ITERATION)").quantity == Quantity::iteration);
    CHECK(amount("(U * 2)").quantity == Quantity::expression);
}

TEST_CASE("constant expressions stand wherever a number stands") {
    const Experiment e = parsed(
        "define parameter n 5\ndefine chemical U limit (2 * PI)\ndefine time_step (1 / 8)\n"
        "use chemical U conc (1 + 1) dev (0.5 ^ 2) diff (sqrt(4))\ncreate matrix (2 * n) (n + 1)\nstop at (10 * n)\n");
    CHECK(e.chemicals[0].bounds.limit == 2 * std::numbers::pi);
    CHECK(e.phases[0].time_step == 0.125);
    CHECK(e.stop_at == 50);
    const Snapshot state = initial_state(e);
    CHECK(state.columns == 10);
    CHECK(state.rows == 6);
    CHECK(state.diff[0][0] == 2);
}

TEST_CASE("names with a minus are names where they are known, else a difference") {
    const Experiment e = parsed(
        "define chemical a floor none\ndefine chemical b floor none\ndefine chemical a-b floor none\n"
        "use chemical a conc 7\nuse chemical b conc 3\nuse chemical a-b conc (a - b)\ncreate sqr_grid 1 1\n"
        "set cell 0 chemical a conc (a-b + b-a)\n");
    CHECK(initial_state(e, Precision::double_).conc[0][0] == 4 + 3 - 7);
}

TEST_CASE("a formula changes each of its chemicals, and if (TRUTH) is a condition") {
    const Rule rule = rule_on_grid("rule if (U > 1 and V < 2) react U by (V - U) V by (U * V)");
    const auto formula = std::get<Formula>(rule.action);
    REQUIRE(formula.parts.size() == 2);
    CHECK(formula.parts[1].chemical == 1);
    const auto compare = std::get<Compare>(rule.condition);
    CHECK(compare.left.quantity == Quantity::expression);
    CHECK(compare.comparison == Comparison::not_equal);
    const auto plain = std::get<Compare>(rule_on_grid("rule if (U + V) > 2 react U by 1").condition);
    CHECK(plain.comparison == Comparison::greater);
}

TEST_CASE("fields are computed from the place, and parts of expressions that depend on it alone become fields") {
    const Experiment e = parsed(
        "define chemical U floor none\ndefine field slope (COLUMN / (COLUMNS - 1))\ndefine field twice (2 * slope + "
        "ROW)\n"
        "create matrix 5 3\nrule always react U by (U * sqrt(X * X + Y * Y) + twice)\n");
    REQUIRE(e.fields.size() == 3);
    CHECK(e.fields[2].name.empty());
    const auto values = field_values(e, {5, 3, 0, 0}, Precision::double_);
    CHECK(values[0][4] == 1);
    CHECK(values[1][5 + 1] == 1.5);
    CHECK(values[2][0] == std::sqrt(16.0 + 4.0));
    CHECK(e.expressions[0].nodes.size() == 5);  // U, the field, product, twice, sum
}

TEST_CASE("RANDOM in fields and starts is drawn apart for each of them, and follows the seed") {
    const auto start = [](const std::string& seed) {
        return initial_state(
            parsed("use seed " + seed +
                   "\ndefine chemical U\ndefine chemical V\ndefine field noise (RANDOM)\n"
                   "use chemical U conc (RANDOM)\nuse chemical V conc (noise)\ncreate matrix 40 40\n"));
    };
    const Snapshot one = start("5"), again = start("5"), other = start("6");
    CHECK(one.conc == again.conc);
    CHECK(one.conc[0] != other.conc[0]);
    CHECK(one.conc[1] != other.conc[1]);
    CHECK(one.conc[0] != one.conc[1]);
    double sum = 0;
    for (const double value : one.conc[0]) sum += value;
    CHECK(sum / 1600 == Approx(0.5).margin(0.03));
}

TEST_CASE("cells are set where an expression holds") {
    const Snapshot state =
        initial_state(parsed("define chemical U\ndefine chemical V\nuse chemical V conc 3\ncreate matrix 9 9\n"
                             "set cells where (hypot(X, Y) < 5) chemical U conc (0.5 + V) diff 2 chemical V conc 1\n"));
    std::size_t inside = 0;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        const bool near = std::hypot(state.x[cell], state.y[cell]) < 5;
        inside += near ? 1 : 0;
        CHECK(state.conc[0][cell] == (near ? 3.5 : 0.0));
        CHECK(state.diff[0][cell] == (near ? 2.0 : 0.0));
        CHECK(state.conc[1][cell] == (near ? 1.0 : 3.0));
    }
    CHECK(inside == 21);
}

TEST_CASE("what one line sets is set in the same cells") {
    const std::string world = "define chemical U\ndefine chemical V\nuse seed 3\ncreate matrix 30 30\n";
    const Snapshot drawn =
        initial_state(parsed(world + "set cells where (RANDOM < 0.25) chemical U conc 1 chemical V conc 1\n"
                                     "set cells where (RANDOM < 0.25) chemical V diff 1\n"));
    CHECK(drawn.conc[0] == drawn.conc[1]);
    CHECK(drawn.conc[0] != drawn.diff[1]);  // another line draws anew
    const Snapshot changed =
        initial_state(parsed(world + "set cells where (U == 0) chemical U conc 2 chemical V conc 3\n"));
    CHECK(changed.conc[1] == std::vector<double>(900, 3.0));
}

TEST_CASE("previous(U) is what U was an iteration ago, and U itself at the start") {
    const Experiment e = parsed(
        "define chemical U\nuse chemical U conc 5\ncreate matrix 3 3\nset cell 4 chemical U conc 7\n"
        "phase \"a\" 5\nrule always change U conc (previous(U))\nphase \"b\" 5\ndefine chemical U limit 9\n");
    REQUIRE(e.chemicals.size() == 2);
    CHECK(e.chemicals[1].name == "previous(U)");
    const Snapshot state = initial_state(e);
    CHECK(state.conc[1] == state.conc[0]);
    CHECK(std::holds_alternative<Set>(e.rules.back().action));
    CHECK(e.rules.back().until == forever);
}

TEST_CASE("an expression is refused where its values cannot be known or its values are beyond bounds") {
    const ErrorCase cases[] = {
        {grid, "define field f (U)",
         "t.pex:4:17: 'U' changes while the experiment runs; a field is computed once, from the place"},
        {grid, "define field f (2 * ITERATION)",
         "t.pex:4:21: 'ITERATION' changes while the experiment runs; a field is computed once, from the place"},
        {grid, "define field U (X)", "t.pex:4:14: 'U' is a chemical; choose another name"},
        {grid, "define field f (X)\ndefine field f (Y)", "t.pex:5:14: field 'f' is defined already"},
        {grid, "define field f 3", "t.pex:4:16: the field must be an expression in parentheses"},
        {grid, "use chemical U conc (TIME)", "t.pex:4:22: 'TIME' is known in rules alone, not at the start"},
        {grid, "use chemical U conc (X) dev 1",
         "t.pex:4:25: an expression takes no 'dev'; draw within it, with RANDOM"},
        {grid, "use chemical U conc (previous(V))", "t.pex:4:22: 'previous' is known in rules alone, not at the start"},
        {grid, "set cells where X chemical U conc 1",
         "t.pex:4:17: what holds for the cells must be an expression in parentheses"},
        {grid, "stop at (2 * U)",
         "t.pex:4:14: unknown name 'U' in an expression; known here: if, and, or, not, PI, and functions"},
        {grid, "stop at (5 / 2)",
         "t.pex:4:9: expression '(5 / 2)' is 2.5, which is not a whole number; the last iteration must be a whole "
         "number from 0 to 4294967295"},
        {grid, "rule always react U by (V) U by 2", "t.pex:4:28: 'U' is given twice; its rate must be one expression"},
        {grid, "rule always react U by", "(the operand)"},
        {"define chemical U\n", "create hex_circle 2\nrule always change U conc (laplacian(U))",
         "t.pex:3:28: 'laplacian' needs a lattice (a matrix, or a single sqr_grid without 'divide' and 'move'), a "
         "volume "
         "or a mesh; free cells have X and Y"},
    };
    for (const ErrorCase& one : cases) {
        if (one.message == "(the operand)") {
            CHECK_THAT(message_of(one.prelude + one.text), Catch::StartsWith("t.pex:4:23: the line ends too early"));
        } else {
            check_error(one);
        }
    }
    CHECK_THROWS_WITH(
        initial_state(parsed("define chemical U limit 1\nuse chemical U conc (X)\ncreate matrix 4 1\n")),
        "t.pex:2:21: an expression starts 'U' with the concentration -3 in cell 0; it must be a number from 0 to 1");
    CHECK_THROWS_WITH(initial_state(parsed("define chemical U\nuse chemical U diff (X)\ncreate matrix 4 1\n")),
                      Catch::Contains("'U' with the diffusion rate -3 in cell 0"));
}

namespace {

struct Malformed {
    const char* expression;
    int column;
    const char* message;
};

}  // namespace

TEST_CASE("malformed expressions say where and what is allowed") {
    const Malformed cases[] = {
        {"()", 28, "')' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(1 + * 2)", 32, "'*' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(U + q)", 32,
         "unknown name 'q' in an expression; known here: U, V, NEIGHBORS, AGE, BIRTH, X, Y, Z, ROW, COLUMN, LAYER, "
         "ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, if, and, or, not, PI, and functions"},
        {"(exp(U, V))", 33, "exp(x) takes 1 value"},
        {"(exp())", 32, "exp(x) takes 1 value"},
        {"(1/0)", 29, "'/' gives inf here, which no number of a run can be"},
        {"(0/0)", 29, "'/' gives no number here"},
        {"(sqrt(-1))", 28, "'sqrt' gives no number here"},
        {"(log(0))", 28, "'log' gives -inf here, which no number of a run can be"},
        {"(1e30 * 1e30)", 33, "'*' gives 1e+60 here, which no number of a run can be"},
        {"(U < V < 1)", 34, "comparisons do not chain; write 'a < b and b < c'"},
        {"(U == V == 1)", 35, "comparisons do not chain; write 'a < b and b < c'"},
        {"(2U)", 29, "'U' follows a number; a product needs its '*'"},
        {"(2(U))", 29, "'(' follows a number; a product needs its '*'"},
        {"(2.5.1)", 31, "'.1' follows a number; a product needs its '*'"},
        {"(U && V)", 30, "'&&' follows a value; an operator or ')' must; write 'and'"},
        {"(U || V)", 30, "'||' follows a value; an operator or ')' must; write 'or'"},
        {"(!U)", 28, "'!' cannot stand here; a value must: a number, a name, a function or '('; write 'not'"},
        {"(if U)", 28, "'if' is written if(TRUTH, VALUE, OTHERWISE)"},
        {"(if(U, 1))", 35, "if(TRUTH, VALUE, OTHERWISE) takes 3 values"},
        {"(if(U, 1, 2, 3))", 38, "if(TRUTH, VALUE, OTHERWISE) takes 3 values"},
        {"(a = 3)", 28,
         "unknown name 'a' in an expression; known here: U, V, NEIGHBORS, AGE, BIRTH, X, Y, Z, ROW, COLUMN, LAYER, "
         "ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, if, and, or, not, PI, and functions"},
        {"(U = 3)", 30, "'=' follows a value; an operator or ')' must; equality is '=='"},
        {"(U V)", 30, "'V' follows a value; an operator or ')' must"},
        {"(U 2)", 30, "'2' follows a value; an operator or ')' must"},
        {"(max(U))", 33, "max(a, b) takes 2 values"},
        {"(max(U, V, 1))", 36, "max(a, b) takes 2 values"},
        {"(max(U,,V))", 34, "',' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(max(U V))", 34, "'V' follows a value; ',' or ')' must"},
        {"(max(U, V)", 27, "this parenthesis is not closed; expressions end on the same line"},
        {"(max(U,)", 27, "this parenthesis is not closed; expressions end on the same line"},
        {"(max U)", 28, "'max' is a function; write max(...)"},
        {"(not)", 31, "')' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(and U)", 28, "'and' stands between truths; a value is missing before it"},
        {"(U and)", 33, "')' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(U or or V)", 33, "'or' stands between truths; a value is missing before it"},
        {"(U not V)", 30, "'not' follows a value; an operator or ')' must"},
        {"(U ^ )", 32, "')' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(^ 2)", 28, "'^' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(* U)", 28, "'*' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(U -)", 31, "')' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(-)", 29, "')' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(exp)", 28, "'exp' is a function; write exp(...)"},
        {"(diff(3))", 33, "'diff' takes the name of a chemical; found '3'"},
        {"(diff(q))", 33, "'diff' takes the name of a chemical; found 'q'"},
        {"(diff())", 33, "'diff' takes the name of a chemical; found ')'"},
        {"(diff(U V))", 35, "'diff(NAME' is not closed"},
        {"(laplacian(U + V))", 40, "'laplacian(NAME' is not closed"},
        {"(gradient_x(2))", 39, "'gradient_x' takes the name of a chemical; found '2'"},
        {"(U(3))", 28, "'U' is no function; a product needs its '*'"},
        {"(1 2)", 30, "'2' follows a value; an operator or ')' must"},
        {"(U))", 30, "')' follows a statement that is complete"},
        {"((U)", 27, "this parenthesis is not closed; expressions end on the same line"},
        {"(3 % 2)", 30, "'%' follows a value; an operator or ')' must; write 'mod(a, b)'"},
        {"(U ** 2)", 30, "'**' follows a value; an operator or ')' must; a power is '^'"},
        {"(1e999)", 28, "'1e999' is no number that a float can hold"},
        {"(.)", 28, "'.' is no number that a float can hold"},
        {"(U # 2)", 30, "'#' follows a value; an operator or ')' must"},
        {"(U $)", 30, "'$' follows a value; an operator or ')' must"},
        {"(PI PI)", 31, "'PI' follows a value; an operator or ')' must"},
        {"(1 if 2)", 30, "'if' follows a value; an operator or ')' must"},
        {"(random)", 28,
         "unknown name 'random' in an expression; known here: U, V, NEIGHBORS, AGE, BIRTH, X, Y, Z, ROW, COLUMN, "
         "LAYER, ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, if, and, or, not, PI, and functions; did you mean "
         "'RANDOM'?"},
        {"(iteration)", 28,
         "unknown name 'iteration' in an expression; known here: U, V, NEIGHBORS, AGE, BIRTH, X, Y, Z, ROW, COLUMN, "
         "LAYER, ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, if, and, or, not, PI, and functions; did you mean "
         "'ITERATION'?"},
        {"(TIME.)", 32, "'.' follows a value; an operator or ')' must"},
        {"(U; V)", 29, "';' follows a value; an operator or ')' must"},
        {"([U])", 28, "'[' cannot stand here; a value must: a number, a name, a function or '('"},
        {"({U})", 28, "'{' cannot stand here; a value must: a number, a name, a function or '('"},
        {"('U')", 28, "''' cannot stand here; a value must: a number, a name, a function or '('"},
        {"(U, V)", 29, "',' follows a value; an operator or ')' must"},
    };
    for (const auto& [expression, column, message] : cases) {
        check_error({grid, fmt::format("rule always change U conc {}", expression),
                     fmt::format("t.pex:4:{}: {}", column, message)});
    }
    CHECK_THAT(message_of(grid + "rule always change U conc (sinn(U))"),
               Catch::StartsWith("t.pex:4:28: unknown function 'sinn'; there are: conc, previous, diff, laplacian, "
                                 "gradient_x, gradient_y, gradient_z, if, abs, ") &&
                   Catch::EndsWith("; did you mean 'sin'?"));
}

TEST_CASE("expressions that are too deep, too long or too many are refused") {
    const std::string deep(500, '('), open(500, ')');
    CHECK_THAT(message_of(grid + "rule always change U conc " + deep + "U" + open),
               Catch::Contains("the expression is nested too deeply; at most 100 levels are allowed"));
    std::string sum = "(U";
    for (int i = 0; i < 600; ++i) sum += "+U";
    CHECK_THAT(message_of(grid + "rule always change U conc " + sum + ")"),
               Catch::Contains("the expression is too long; at most 1000 values and operators are allowed"));
    std::string many;
    for (int i = 0; i < 257; ++i) many += "rule always change U conc (U + V)\n";
    CHECK_THAT(message_of(grid + many), Catch::Contains("one expression too many; at most 256 are allowed"));
}
