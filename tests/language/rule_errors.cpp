// rules: each malformed line with the whole message it must give.
#include "language/error_case.hpp"

#include "core/models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace test;

namespace {

// All words of the table, as they stand in messages.
std::string reactions() {
    std::vector<std::string> words;
    for (const pelage::ModelFacts& model : pelage::model_table()) words.push_back(model.word);
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

TEST_CASE("malformed rules say where and what is allowed") {
    const ErrorCase cases[] = {
        {grid, "rule always",
         "t.pex:4:12: the line ends too early; allowed here: react, change, set, map, polarize, divide, move, expand, "
         "aggregate, and"},
        {grid, "rule sometimes and",
         "t.pex:4:6: unknown word 'sometimes'; allowed here: always, if, probability, from, until, every, offset"},
        {grid, "rule from 5 until 3.5 always and",
         "t.pex:4:19: '3.5' is not a whole number; the last iteration must be a whole number from 0 to 4294967295"},
        {grid, "rule from -1 always and",
         "t.pex:4:11: '-1' is out of range; the first iteration must be a whole number from 0 to 4294967295"},
        {grid, "rule from 5000000000 always and",
         "t.pex:4:11: '5000000000' is out of range; the first iteration must be a whole number from 0 to 4294967295"},
        {grid, "rule every 0 always and",
         "t.pex:4:12: '0' is out of range; the period must be a whole number from 1 to 4294967295"},
        {grid, "rule offset 3 always and", "t.pex:4:6: 'offset' belongs to a period; write 'every INT' before it"},
        {grid, "rule if U conc = 1 and", "t.pex:4:16: unknown word '='; allowed here: ==, !=, <, <=, >, >=, in"},
        {grid, "rule if U > 1 and", "t.pex:4:11: unknown word '>'; allowed here: conc, diff"},
        {grid, "rule if W conc > 1 and",
         "t.pex:4:9: unknown name 'W'; the value compared must be one of: a number, NEIGHBORS, AGE, BIRTH, X, Y, Z, "
         "ROW, COLUMN, LAYER, ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, conc or diff of a chemical (U, V), an "
         "expression in "
         "parentheses"},
        {grid, "rule if U conc > and",
         "t.pex:4:18: unknown name 'and'; the value compared with must be one of: a number, NEIGHBORS, AGE, BIRTH, X, "
         "Y, Z, ROW, COLUMN, LAYER, ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, conc or diff of a chemical (U, V), "
         "an expression in "
         "parentheses"},
        {grid, "rule if U conc in 1 and",
         "t.pex:4:21: unknown name 'and'; the interval's high end must be one of: a number, NEIGHBORS, AGE, BIRTH, X, "
         "Y, Z, ROW, COLUMN, LAYER, ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, conc or diff of a chemical (U, V), "
         "an expression in "
         "parentheses"},
        {grid, "rule probability 1.5 and",
         "t.pex:4:18: '1.5' is out of range; the probability must be a number from 0 to 1"},
        {grid, "rule probability -1 and",
         "t.pex:4:18: '-1' is out of range; the probability must be a number from 0 to 1"},
        {grid, "rule always jump",
         "t.pex:4:13: unknown word 'jump'; allowed here: react, change, set, map, polarize, divide, move, expand, "
         "aggregate, and"},
        {grid, "rule always and and", "t.pex:4:17: 'and' follows a statement that is complete"},
        {grid, "rule always react U W turing alpha 16 beta 12", "t.pex:4:21: unknown chemical 'W'; defined here: U, V"},
        {grid, "rule always react U U turing alpha 16 beta 12",
         "t.pex:4:21: 'U' reacts with itself; give two different chemicals"},
        {grid, "rule always react U turing alpha 16 beta 12",
         "t.pex:4:21: 'turing' takes two chemicals; write 'react NAME NAME turing'"},
        {grid, "rule always react U V U turing alpha 16 beta 12",
         "t.pex:4:23: 'turing' takes two chemicals; write 'react NAME NAME turing'"},
        {grid, "rule always react U V reinforcement threshold 1 width 1",
         "t.pex:4:21: 'reinforcement' takes one chemical; write 'react NAME reinforcement'"},
        {grid, "rule always react U V turring alpha 16 beta 12",
         "t.pex:4:23: unknown word 'turring'; allowed here: " + reactions() + "; did you mean 'turing'?"},
        {grid, "rule always react U V turing beta 12 alpha 16", "t.pex:4:30: unknown word 'beta'; allowed here: alpha"},
        {grid, "rule always react U V gray-scott f 0.03", "t.pex:4:40: the line ends too early; allowed here: k"},
        {grid, "rule always react U V scale 1e999 turing alpha 16 beta 12",
         "t.pex:4:29: '1e999' is beyond what a float can hold; the scale must be a number"},
        {grid, "rule always change U 1", "t.pex:4:22: unknown word '1'; allowed here: conc, diff"},
        {grid, "rule always change U conc ++1", "t.pex:4:27: '++1' is not a number; the amount must be a number"},
        {grid, "rule always set U conc",
         "t.pex:4:23: the line ends too early; the value must be one of: a number, NEIGHBORS, AGE, BIRTH, X, Y, Z, "
         "ROW, COLUMN, LAYER, ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, conc or diff of a chemical (U, V), an "
         "expression in "
         "parentheses"},
        {grid, "rule always map U conc 1 1 to BETA 0 1",
         "t.pex:4:26: the interval is empty; 'map' needs two different ends"},
        {grid, "rule if U conc > 1 map U conc 0 1 to BETA 0 1",
         "t.pex:4:20: 'map' takes the condition 'always' and no other"},
        {grid, "rule always map U conc 0 1 to V 0 1", "t.pex:4:31: 'V' is a chemical; choose another name"},
        {grid, "rule always map U conc 0 1 to AGE 0 1",
         "t.pex:4:31: 'AGE' cannot name a mapping; it is a word of rules"},
        {grid, "rule always change U conc BETA",
         "t.pex:4:27: unknown name 'BETA'; the amount must be one of: a number, NEIGHBORS, AGE, BIRTH, X, Y, Z, ROW, "
         "COLUMN, LAYER, ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, conc or diff of a chemical (U, V), an "
         "expression in "
         "parentheses"},
        {grid, "rule always polarize U diff", "t.pex:4:24: unknown word 'diff'; allowed here: conc"},
        {grid, "rule always divide angle 90", "t.pex:4:20: unknown word 'angle'; allowed here: direction"},
        {grid, "rule always move",
         "t.pex:4:17: the line ends too early; the distance must be one of: a number, NEIGHBORS, AGE, BIRTH, X, Y, Z, "
         "ROW, COLUMN, LAYER, ROWS, COLUMNS, LAYERS, ITERATION, TIME, RANDOM, conc or diff of a chemical (U, V), an "
         "expression in "
         "parentheses"},
        {grid, "rule always expand columns 1",
         "t.pex:4:13: 'expand' needs a matrix; write 'create matrix COLUMNS ROWS'"},
        {matrix, "rule always divide", "t.pex:4:13: 'divide' needs free cells; the elements of a matrix stay in place"},
        {matrix, "rule always move 1", "t.pex:4:13: 'move' needs free cells; the elements of a matrix stay in place"},
        {matrix, "rule if U conc > 1 expand columns 1",
         "t.pex:4:20: 'expand' takes the condition 'always' and no other"},
        {matrix, "rule always expand first rows",
         "t.pex:4:13: 'expand' inserts nothing; give 'columns INT' or 'rows INT'"},
        {matrix, "rule always expand columns 1 distribution shuffle",
         "t.pex:4:43: unknown word 'shuffle'; allowed here: uniform, shuffled, normal, triangular; did you mean "
         "'shuffled'?"},
        {matrix, "rule always expand columns 1 weight 0.5 rows 0.4 to 0.6",
         "t.pex:4:30: 'weight ... rows' weighs the insertion of rows; give 'rows INT'"},
        {matrix, "rule always expand rows 1 weight 0.5 rows 0.6 to 0.4",
         "t.pex:4:50: the band's high end is below its low end"},
        {matrix, "rule always expand rows 1 distribution shuffled weight 2 rows 0.4 to 0.6",
         "t.pex:4:49: 'shuffled' picks every place equally often; 'weight' needs another distribution"},
        {matrix, "rule always expand columns 1 by cubic",
         "t.pex:4:33: unknown word 'cubic'; allowed here: nearest, bilinear, bicubic; did you mean 'bicubic'?"},
        {matrix, "rule always expand columns 1 by",
         "t.pex:4:32: the line ends too early; allowed here: nearest, "
         "bilinear, bicubic"},
        {matrix, "rule always expand by nearest",
         "t.pex:4:13: 'expand' inserts nothing; give 'columns INT' or 'rows INT'"},
        {matrix, "rule always expand rows 1 by nearest distribution uniform",
         "t.pex:4:13: 'by' stretches the matrix and draws nothing; leave out 'first', 'distribution' and 'weight'"},
        {matrix, "rule always expand columns 1000 rows 1000",
         "t.pex:4:13: the matrix grows to 10000020 x 10000010 elements; at most 2147483647 cells are allowed"},
        {grid, "rule always divide\nrule if ROW == 3 and",
         "t.pex:5:9: 'ROW' needs a lattice (a matrix, or a single sqr_grid without 'divide' and 'move') or a volume; "
         "free cells "
         "have X and Y"},
    };

    for (const ErrorCase& one : cases) check_error(one);
}
