// Every rule and property of free cells on the device against the reference, bit for bit, in float and double.
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "reference/cells.hpp"
#include "support/free_cells.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace pelage;

namespace {

// Chemicals whose values, rates and places differ from cell to cell.
const std::string mixed = R"(
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

struct Feature {
    const char* name;
    std::string lines;
};

const std::vector<Feature> features{
    {"diffusion and collision alone", ""},
    {"turing", "rule always react A B scale 0.01 turing alpha 16 beta 12\n"},
    {"gray-scott", "rule always react A B scale 0.01 gray-scott f 0.03 k 0.06\n"},
    {"linear",
     "rule always react A B scale 0.1 linear au 0.08 bu -0.08 cu 0.2 du 0.03 mu 0.2 av 0.1 bv 0 cv -0.15 dv 0.06 mv "
     "0.5\n"},
    {"gm1", "rule always react A B scale 0.01 gm1 a 0.1 b 0.2 c 0.3\n"},
    {"cubic", "rule always react A B scale 0.01 cubic a 0 b 2 c 5\n"},
    {"reinforcement", "rule always react A scale 0.1 reinforcement threshold 3 width 1\n"},
    {"several chemicals in one reaction's parameters",
     "rule always react A B scale C conc turing alpha B diff beta 12\n"},
    {"change and its deviation",
     "rule every 3 offset 1 if A conc > 3 change B conc 0.25 dev 0.1\n"
     "rule probability 0.1 change A diff -0.01\n"},
    {"set", "rule if NEIGHBORS > 5 set A conc B conc\nrule if AGE in 4 9 set B diff 0.03\n"},
    {"map",
     "rule always map X -10 10 to M 0 1\nrule always map A conc 1 5 to N 3 2\n"
     "rule always change A conc M\nrule if N < 2.5 change B diff 0.001\n"},
    {"and",
     "rule if A conc > 2 and\nrule if B conc < 3 and\nrule probability 0.5 change C conc 0.125\n"
     "rule until 5 always and\nrule always change B conc 0.01\n"},
    {"random operands", "rule if RANDOM < 0.5 change A conc RANDOM dev 0.2\nrule always change B conc RANDOM\n"},
    {"polarize", "rule always polarize A conc\n"},
    {"polarize by several chemicals",
     "rule always polarize A conc\nrule if B conc > 2 polarize C conc\n"
     "rule probability 0.3 polarize B conc\n"},
    {"move", "rule always move 0.05 dev 0.02\nrule if Y > 0 move A conc\n"},
    {"divide in several ways",
     "rule probability 0.02 divide direction 45 dev 20\nrule if A conc > 4.9 and\n"
     "rule probability 0.1 divide\nrule if AGE == 7 divide direction A conc\n"},
    {"divide while polarized", "rule always polarize A conc\nrule probability 0.03 divide direction 90\n"},
    {"divide while mapped", "rule always map A conc 0 6 to M 0 360\nrule probability 0.03 divide direction M\n"},
    {"division limit", "define division_limit 5\nrule probability 0.2 divide direction 0 dev 180\n"},
    {"packed domain", "define domain packed area 3\nrule probability 0.02 divide direction 0 dev 180\n"},
    {"narrow domain", "define domain 20 12\n"},
    {"rules that come and go",
     "rule from 3 until 8 always change A conc 0.01\nrule from 5 always change B conc 0.02\n"
     "rule every 2 always change C conc 0.03\nrule every 7 offset 3 probability 0.5 divide\n"},
    {"phases",
     "phase \"one\" 6\nrule always change A conc 0.1\nphase \"two\" 9\ndefine time_step 0.5\n"
     "use chemical B diff 0.07\ndefine chemical A limit 5 floor 1\nrule every 2 always change B conc 0.1\n"}};

}  // namespace

TEST_CASE("free cells: each feature on the device equals the reference") {
    const auto& feature = GENERATE(from_range(features));
    CAPTURE(feature.name);
    const auto experiment = test::experiment(mixed + feature.lines);

    const auto expected = test::on_reference(experiment);
    const auto found = test::on_device(experiment);

    test::check_equal_runs(*expected, *found, 40, 8);
}

TEST_CASE("free cells: many features at once, in float and double") {
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    CAPTURE(static_cast<int>(precision));
    std::string lines = mixed;
    for (const Feature& feature : features) {
        if (feature.lines.rfind("rule", 0) == 0) lines += feature.lines;
    }
    const auto experiment = test::experiment(lines);

    const auto expected = test::on_reference(experiment, precision);
    const auto found = test::on_device(experiment, {}, precision);

    test::check_equal_runs(*expected, *found, 30, 6);
}

TEST_CASE("free cells: experiments without a polarity, a chemical or a neighbour") {
    const std::string lines =
        GENERATE(as<std::string>{},
                 "define chemical A\nuse chemical A conc 3 diff 0.1\ncreate cell 0 0\n"
                 "rule always change A conc 1\n",
                 "define chemical A\nuse chemical A conc 3 dev 1\ncreate cell 0 0\ncreate cell 1 0\n",
                 "define chemical A\nuse chemical A diff 0.1\ncreate cell 5 5\ncreate cell 5 5\n"
                 "rule always change A conc RANDOM\n");
    CAPTURE(lines);
    const auto experiment = test::experiment(lines);

    const auto expected = test::on_reference(experiment);
    const auto found = test::on_device(experiment);

    test::check_equal_runs(*expected, *found, 10, 1);
}

TEST_CASE("free cells: mirror pairs, also where pairs share cells") {
    const auto experiment =
        test::experiment(mixed + "rule probability 0.1 change A diff 0.01\nrule probability 0.02 divide\n");
    Snapshot initial = initial_state(*experiment);
    initial.mirrors = {{0, 12}, {1, 11}, {11, 2}, {100, 5}, {5, 12}, {7, 8}};

    const auto expected = make_reference_cells(experiment, initial, Precision::single_);
    const auto found = test::on_device(experiment);
    found->write(initial);

    test::check_equal_runs(*expected, *found, 40, 8);
    CHECK(found->read().mirrors == initial.mirrors);
}
