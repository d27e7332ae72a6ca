// See cases_cells.hpp.
#include "verify/cases_cells.hpp"

#include "core/models.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

namespace pelage::verify {

// Chemicals whose values, rates and places differ from cell to cell.
const std::string cell_tissue = R"(
define chemical A limit 6
define chemical B
define chemical C anisotropic
use seed 3
use chemical A conc 3 dev 2 diff 0.05 dev 0.02
use chemical B conc 2 dev 1 diff 0.02
use chemical C conc 1 dev 1 diff 0.04
use polarity 30 dev 60
create hex_grid 13 11 dev 0.3
use polarity none
create hex_circle 4 at 30 5 fixed
)";

namespace {

// On chemicals of its own.
CellCase reacting(const ModelFacts& model) {
    CellCase made{"cells/" + model.word, "rule always react", ""};
    for (const ModelSpecies& species : model.species) {
        const std::string name = model.word + "_" + species.name;  // of its own where many cases stand together
        made.before += fmt::format("define chemical {0} floor none\nuse chemical {0} conc {1} dev {2} diff 0.05\n",
                                   name, (species.low + species.high) / 2, (species.high - species.low) / 2);
        made.lines += " " + name;
    }
    made.lines += " scale 0.01 " + model.word;
    const std::vector<double> numbers = sensible(model, 0);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        made.lines += fmt::format(" {} {}", model.parameters[i].name, numbers[i]);
    made.lines += "\n";
    return made;
}

// The last two cells are just as steep as no gradient is followed yet.
const std::string hardly_steep =
    "use chemical A conc 0\ncreate cell 0 40 fixed\nuse chemical A conc 0.0001\ncreate cell 2 40 fixed\n"
    "rule always polarize A conc\n";

std::vector<CellCase> features() {
    return {{"cells/diffusion-and-collision-alone", ""},
            {"cells/several-chemicals-in-one-reactions-parameters",
             "rule always react A B scale C conc turing alpha B diff beta 12\n"},
            {"cells/change-and-its-deviation",
             "rule every 3 offset 1 if A conc > 3 change B conc 0.25 dev 0.1\n"
             "rule probability 0.1 change A diff -0.01\n"},
            {"cells/set", "rule if NEIGHBORS > 5 set A conc B conc\nrule if AGE in 4 9 set B diff 0.03\n"},
            {"cells/map",
             "rule always map X -10 10 to M 0 1\nrule always map A conc 1 5 to N 3 2\n"
             "rule always change A conc M\nrule if N < 2.5 change B diff 0.001\n"},
            {"cells/and",
             "rule if A conc > 2 and\nrule if B conc < 3 and\nrule probability 0.5 change C conc 0.125\n"
             "rule until 5 always and\nrule always change B conc 0.01\n"},
            {"cells/random-operands",
             "rule if RANDOM < 0.5 change A conc RANDOM dev 0.2\nrule always change B conc RANDOM\n"},
            {"cells/polarize", "rule always polarize A conc\n"},
            {"cells/polarize-by-several-chemicals",
             "rule always polarize A conc\nrule if B conc > 2 polarize C conc\n"
             "rule probability 0.3 polarize B conc\n"},
            {"cells/at-one-place",
             "use chemical C conc 2 diff 0.03\nuse polarity 200\ncreate cell 1 1\ncreate cell 1 1\n"
             "use polarity none\ncreate cell 1 1\ncreate cell 3 1\ncreate cell -8.5 4 fixed\ncreate cell -8.5 4 fixed\n"
             "rule always polarize A conc\nrule if B conc > 2 polarize C conc\n"
             "rule every 5 offset 2 if AGE < 9 divide direction 30\n"},
            {"cells/move", "rule always move 0.05 dev 0.02\nrule if Y > 0 move A conc\n"},
            {"cells/divide-in-several-ways",
             "rule probability 0.02 divide direction 45 dev 20\nrule if A conc > 4.9 and\n"
             "rule probability 0.1 divide\nrule if AGE == 7 divide direction A conc\n"},
            {"cells/divide-while-polarized", hardly_steep + "rule probability 0.03 divide direction 90\n"},
            {"cells/divide-while-mapped",
             "rule always map A conc 0 6 to M 0 360\nrule probability 0.03 divide direction M\n"},
            {"cells/division-limit", "define division_limit 5\nrule probability 0.2 divide direction 0 dev 180\n"},
            {"cells/packed-domain", "define domain packed area 2.9\nrule probability 0.1 divide direction 0 dev 180\n"},
            {"cells/narrow-domain", "define domain 20 12\n"},
            {"cells/rules-that-come-and-go",
             "rule from 3 until 8 always change A conc 0.01\nrule from 5 always change B conc 0.02\n"
             "rule every 2 always change C conc 0.03\nrule every 7 offset 3 probability 0.5 divide\n"},
            {"cells/phases",
             "phase \"one\" 6\nrule always change A conc 0.1\nphase \"two\" 9\ndefine time_step 0.5\n"
             "use chemical B diff 0.07\ndefine chemical A limit 5 floor 1\nrule every 2 always change B conc 0.1\n"}};
}

}  // namespace

const std::vector<CellCase>& cell_cases() {
    static const std::vector<CellCase> table = [] {
        std::vector<CellCase> cases = features();
        for (const ModelFacts& model : model_table()) cases.push_back(reacting(model));
        return cases;
    }();
    return table;
}

}  // namespace pelage::verify
