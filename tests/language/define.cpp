// define and use: what they put into the Experiment.
#include "language/parsed.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace pelage;
using namespace test;

TEST_CASE("a chemical has bounds and a direction, in any order of options") {
    const Experiment e = parsed(
        "define chemical A\n"
        "define chemical B limit 4.05 anisotropic\n"
        "define chemical C anisotropic floor -2 limit +3\n"
        "define chemical D floor none limit none\n"
        "create sqr_grid 2 2\n");

    REQUIRE(e.chemicals.size() == 4);
    CHECK(e.chemicals[0].name == "A");
    CHECK(e.chemicals[0].bounds.floor == 0.0);
    CHECK(std::isinf(e.chemicals[0].bounds.limit));
    CHECK_FALSE(e.chemicals[0].anisotropic);
    CHECK(e.chemicals[1].bounds.limit == 4.05);
    CHECK(e.chemicals[1].anisotropic);
    CHECK(e.chemicals[2].bounds.floor == -2.0);
    CHECK(e.chemicals[2].bounds.limit == 3.0);
    CHECK(e.chemicals[2].anisotropic);
    CHECK(e.chemicals[3].bounds.floor == -std::numeric_limits<double>::infinity());
    CHECK(std::isinf(e.chemicals[3].bounds.limit));
    CHECK(e.chemicals[3].initial == nullptr);
}

TEST_CASE("a comment may follow a word without a space") {
    const Experiment e =
        parsed("define chemical U //anisotropic\ndefine chemical V//anisotropic\ncreate cell 0 0//!\n");

    CHECK_FALSE(e.chemicals[0].anisotropic);
    CHECK(e.chemicals[1].name == "V");
}

TEST_CASE("windows line ends, a byte order mark, tabs and a missing last line end are read") {
    const Experiment e = parsed(
        "\xef\xbb\xbf"
        "define\tchemical  U\tlimit 3\r\n\r\n\t\r\ncreate sqr_grid 3 4\r\nstop at 7");

    CHECK(e.chemicals.at(0).name == "U");
    CHECK(e.chemicals[0].bounds.limit == 3.0);
    CHECK(e.stop_at == 7);
}

TEST_CASE("the text and its name are kept with the experiment") {
    const std::string text = "define chemical U\ncreate cell 0 0\n// the end\n";

    const Experiment e = parsed(text);

    CHECK(e.text == text);
    CHECK(e.source == "t.pex");
}

TEST_CASE("domain, division limit and time step") {
    CHECK(parsed_on_grid("").domain.width == 1000.0);
    CHECK(parsed_on_grid("").division_limit == 0);
    CHECK(parsed_on_grid("").phases.at(0).time_step == 1.0);

    const Experiment e = parsed_on_grid("define domain 30 40.5\ndefine division_limit 6\ndefine time_step 0.125\n");
    CHECK(e.domain.width == 30.0);
    CHECK(e.domain.height == 40.5);
    CHECK_FALSE(e.domain.packed);
    CHECK(e.division_limit == 6);
    CHECK(e.phases.at(0).time_step == 0.125);

    CHECK(parsed_on_grid("define domain packed").domain.packed);
    CHECK(parsed_on_grid("define domain packed").domain.area == 3.2);
    CHECK(parsed_on_grid("define domain packed area 2.5").domain.area == 2.5);
}

TEST_CASE("stencils of a matrix") {
    CHECK(parsed_on_matrix("").stencil == Stencil::nine_point);
    CHECK(parsed_on_matrix("define stencil moore").stencil == Stencil::moore);
    CHECK(parsed_on_matrix("define stencil nine-point").stencil == Stencil::nine_point);
    CHECK(parsed_on_matrix("define stencil five-point").stencil == Stencil::five_point);
    CHECK(parsed_on_matrix("define stencil sims").stencil == Stencil::sims);
    const Experiment own = parsed_on_matrix("define parameter w 1.5\ndefine stencil 3x3 0 1 0 w (-3 - w) 1 0 1 0");
    CHECK(own.stencil == Stencil::own);
    CHECK(own.weights == StencilWeights{0, 1, 0, 1.5, -4.5, 1, 0, 1, 0});

    const std::string wide = "0 0 -1 0 0  0 0 16 0 0  -1 16 -60 16 -1  0 0 16 0 0  0 0 -1 0 0";
    const Experiment far = parsed_on_matrix("define stencil 5x5 " + wide);
    CHECK(far.stencil == Stencil::own);
    CHECK(far.weights.size() == 25);
    CHECK(far.weights[11] == 16);
    const Experiment named =
        parsed_on_matrix("define stencil far 5x5 " + wide + "\ndefine stencil up 3x3 0 1 0 0 0 0 0 0 0");
    CHECK(named.stencil == Stencil::nine_point);
    REQUIRE(named.stencils.size() == 2);
    CHECK(named.stencils[0].name == "far");
    CHECK(named.stencils[0].weight(0, 2) == -1);
    CHECK(named.stencils[1].weight(0, 1) == 1);
    CHECK(named.stencils[1].weight(0, -1) == 0);
}

TEST_CASE("use chemical sets concentration, rate, both or none") {
    const Experiment e = parsed_on_grid(
        "use chemical V\n"
        "use chemical U conc 4 dev 2 diff 0.75 dev 0.5\n"
        "use chemical V diff .01 conc +1\n");

    const auto use = [&](std::size_t i) { return std::get<UseChemical>(e.prepattern.at(i)); };
    CHECK(use(1).chemical == 1);
    CHECK_FALSE(use(1).conc.has_value());
    CHECK_FALSE(use(1).diff.has_value());
    CHECK(use(2).chemical == 0);
    CHECK(use(2).conc->value == 4.0);
    CHECK(use(2).conc->deviation == 2.0);
    CHECK(use(2).diff->value == 0.75);
    CHECK(use(2).diff->deviation == 0.5);
    CHECK(use(3).conc->value == 1.0);
    CHECK(use(3).conc->deviation == 0.0);
    CHECK(use(3).diff->value == 0.01);
}

TEST_CASE("use polarity and use seed") {
    const Experiment e = parsed_on_grid("use polarity 90 dev 5\nuse polarity none\nuse seed 7\nuse seed -3\n");

    CHECK(std::get<UsePolarity>(e.prepattern.at(1)).degrees->value == 90.0);
    CHECK(std::get<UsePolarity>(e.prepattern[1]).degrees->deviation == 5.0);
    CHECK_FALSE(std::get<UsePolarity>(e.prepattern[2]).degrees.has_value());
    CHECK(std::get<UseSeed>(e.prepattern[3]).seed == 7);
    CHECK(std::get<UseSeed>(e.prepattern[4]).seed == -3);
    CHECK(e.run_seed() == -3);
    CHECK(parsed_on_grid("").run_seed() == 1);
    CHECK(parsed_on_grid("use seed 0").run_seed() == 0);
}
