// words, bytes, lines and files: each malformed line with the whole message it must give.
#include "language/error_case.hpp"

#include <catch2/catch.hpp>

using namespace std::string_literals;
using namespace test;

TEST_CASE("what is no line of the language says where and what is allowed") {
    const ErrorCase cases[] = {
        {grid, "defin chemical W",
         "t.pex:4:1: unknown word 'defin'; allowed here: define, use, create, set, rule, phase, snap, stop, colormap, "
         "output, texture, zoom, include; did you mean 'define'?"},
        {grid, "Rule always and",
         "t.pex:4:1: unknown word 'Rule'; allowed here: define, use, create, set, rule, phase, snap, stop, colormap, "
         "output, texture, zoom, include; did you mean 'rule'?"},
        {grid, R"("define" chemical W)",
         R"(t.pex:4:1: unknown word "define"; allowed here: define, use, create, set, rule, phase, snap, stop, colormap, output, texture, zoom, include)"},
        {grid, "stop at 5\001", "t.pex:4:10: byte 0x01 is not allowed here; words are made of printable ASCII"},
        {grid, "stop at 5 \000"s, "t.pex:4:11: byte 0x00 is not allowed here; words are made of printable ASCII"},
        {grid, "d\303\251fine chemical W",
         "t.pex:4:2: byte 0xc3 is not allowed here; words are made of printable ASCII"},
        {grid, "output U colormap \"r\303\251d at 0, blue at 1\"",
         "t.pex:4:21: byte 0xc3 is not allowed here; words are made of printable ASCII"},
        {grid, "\tstop\tat\tx",
         "t.pex:4:10: 'x' is not a whole number; the last iteration must be a whole number from 0 to 4294967295"},
        {"", "", "t.pex:1:1: the file ends without a chemical; write 'define chemical NAME'"},
        {"", "// nothing but a comment", "t.pex:1:1: the file ends without a chemical; write 'define chemical NAME'"},
        {"", "define chemical U\n", "t.pex:1:1: the file ends without cells; write 'create ...'"},
        {"", "create cell 0 0\nstop at 10",
         "t.pex:2:1: the file ends without a chemical; write 'define chemical NAME'"},
        {"", "\357\273\277define chemical U\r\ncreate sqr_grid 3 3 // nine\r\nstop at none\r\n",
         "t.pex:3:9: 'none' is not a whole number; the last iteration must be a whole number from 0 to 4294967295"},
        {"",
         "define chemical U //anisotropic\ncreate sqr_grid 3 3\nrule always change U conc 1//0\nrule always chnage U "
         "conc 1",
         "t.pex:4:13: unknown word 'chnage'; allowed here: react, change, set, map, polarize, divide, move, expand, "
         "aggregate, and; did you mean 'change'?"},
    };

    for (const ErrorCase& one : cases) check_error(one);
}
