// Phases, snapshots, pictures: what they put into the Experiment.
#include "language/parsed.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace pelage;
using namespace test;

TEST_CASE("without phases there is one, from the start, and a run of 10000 iterations") {
    const Experiment e = parsed_on_grid("define chemical W limit 3 floor none\nuse chemical U diff 0.5\n");

    REQUIRE(e.phases.size() == 1);
    CHECK(e.phases[0].name.empty());
    CHECK(e.phases[0].begin == 0);
    CHECK(e.phases[0].time_step == 1.0);
    REQUIRE(e.phases[0].bounds.size() == 3);
    CHECK(e.phases[0].bounds[2].limit == 3.0);
    CHECK(std::isinf(e.phases[0].bounds[2].floor));
    CHECK(e.phases[0].rates == std::vector<std::optional<double>>(3));
    CHECK(e.stop_at == 10000);
    CHECK(e.last_iteration() == 10000);
}

TEST_CASE("phases follow one another, inherit bounds and time step, and state rates") {
    const Experiment e = parsed_on_grid(
        "define time_step 0.1\n"
        "phase \"definition\" 220000\n"
        "phase \"development\" 12000\n"
        "define time_step 0.05\n"
        "define chemical U limit 5 floor none\n"
        "use chemical V diff 0.25\n"
        "phase \"maintenance\" 10000\n"
        "define chemical U floor 1\n");

    REQUIRE(e.phases.size() == 3);
    CHECK(e.phases[0].name == "definition");
    CHECK(e.phases[0].begin == 0);
    CHECK(e.phases[1].begin == 220000);
    CHECK(e.phases[2].begin == 232000);
    CHECK(e.stop_at == 242000);
    CHECK(e.phases[0].time_step == 0.1);
    CHECK(e.phases[1].time_step == 0.05);
    CHECK(e.phases[2].time_step == 0.05);
    CHECK(std::isinf(e.phases[0].bounds.at(0).limit));
    CHECK(e.phases[0].bounds[0].floor == 0.0);
    CHECK(e.phases[1].bounds.at(0).limit == 5.0);
    CHECK(std::isinf(e.phases[1].bounds[0].floor));
    CHECK(e.phases[2].bounds.at(0).limit == 5.0);
    CHECK(e.phases[2].bounds[0].floor == 1.0);
    CHECK(std::isinf(e.chemicals[0].bounds.limit));
    CHECK_FALSE(e.phases[0].rates.at(1).has_value());
    CHECK(e.phases[1].rates.at(1) == 0.25);
    CHECK_FALSE(e.phases[2].rates.at(1).has_value());
}

TEST_CASE("rules inside a phase count from its start and end with it, rules before hold throughout") {
    const Experiment e = parsed_on_grid(
        "rule from 5 always and\n"
        "phase \"a\" 100\n"
        "rule always and\n"
        "phase \"b\" 50\n"
        "rule from 10 until 20 every 5 offset 1 always and\n"
        "rule until 4000 always and\n");

    CHECK(e.rules.at(0).from == 5);
    CHECK(e.rules[0].until == forever);
    CHECK(e.rules[0].origin == 0);
    CHECK(e.rules.at(1).from == 0);
    CHECK(e.rules[1].until == 99);
    CHECK(e.rules.at(2).from == 110);
    CHECK(e.rules[2].until == 120);
    CHECK(e.rules[2].origin == 100);
    CHECK(e.rules[2].every == 5);
    CHECK(e.rules[2].offset == 1);
    CHECK(e.rules[2].active(111));
    CHECK_FALSE(e.rules[2].active(110));
    CHECK(e.rules.at(3).from == 100);
    CHECK(e.rules[3].until == 149);
}

TEST_CASE("stop wins over phases") {
    CHECK(parsed_on_grid("phase \"a\" 100\nstop at 60\n").stop_at == 60);
    CHECK(parsed_on_grid("stop at 0\n").stop_at == 0);
}

TEST_CASE("snapshots are sorted and single") {
    const Experiment e = parsed_on_grid("snap at 30 10 20 10\nsnap from 5 repeat 3 step 10 then exit\n");

    CHECK(e.snap_at == std::vector<std::uint64_t>{5, 10, 15, 20, 25, 30});
    CHECK(e.exit_after_snaps);
    CHECK(e.last_iteration() == 30);
    CHECK_FALSE(parsed_on_grid("snap at 3").exit_after_snaps);
    CHECK(parsed_on_grid("snap at 3 4 then exit").last_iteration() == 4);
}

TEST_CASE("without output the first chemical is drawn with the selected map") {
    const Experiment plain = parsed_on_grid("");
    REQUIRE(plain.outputs.size() == 1);
    CHECK(plain.outputs[0].chemical == 0);
    CHECK(plain.outputs[0].colormap.name == "heat");
    CHECK(plain.outputs[0].colormap.stops.empty());
    CHECK_FALSE(plain.outputs[0].range.has_value());

    const Experiment e = parsed_on_grid(
        "colormap slot 99 use rgb 1 2 3\ncolormap slot 00 use color \"Chocolate\"\ncolormap select gradient\n"
        "colormap slot 40 use color \"0eE1da\"\ncolormap slot 40 use color \"251c12\"\n");
    const Colormap& map = e.outputs.at(0).colormap;
    CHECK(map.name == "gradient");
    REQUIRE(map.stops.size() == 3);
    CHECK(map.stops[0].at == 0.0);
    CHECK(map.stops[0].rgb == std::array<std::uint8_t, 3>{0xd2, 0x69, 0x1e});
    CHECK(map.stops[1].at == 40.0 / 99.0);
    CHECK(map.stops[1].rgb == std::array<std::uint8_t, 3>{0x25, 0x1c, 0x12});
    CHECK(map.stops[2].at == 1.0);
    CHECK(map.stops[2].rgb == std::array<std::uint8_t, 3>{1, 2, 3});
}

TEST_CASE("outputs in order, each with its range and map") {
    const Experiment e = parsed_on_grid(
        "output V range 0 8.5 colormap inferno\n"
        "output U colormap \"black at 0, 98682d at 0.5\" \"WHITE at 1\" range -1 1\n"
        "output V\n"
        "colormap select striped\n");

    REQUIRE(e.outputs.size() == 3);
    CHECK(e.outputs[0].chemical == 1);
    CHECK(e.outputs[0].colormap.name == "inferno");
    CHECK(e.outputs[0].range == std::array<double, 2>{0.0, 8.5});
    CHECK(e.outputs[1].chemical == 0);
    CHECK(e.outputs[1].colormap.name == "stops");
    REQUIRE(e.outputs[1].colormap.stops.size() == 3);
    CHECK(e.outputs[1].colormap.stops[1].at == 0.5);
    CHECK(e.outputs[1].colormap.stops[1].rgb == std::array<std::uint8_t, 3>{0x98, 0x68, 0x2d});
    CHECK(e.outputs[1].colormap.stops[2].rgb == std::array<std::uint8_t, 3>{255, 255, 255});
    CHECK(e.outputs[1].range == std::array<double, 2>{-1.0, 1.0});
    CHECK(e.outputs[2].colormap.name == "striped");
    CHECK(e.outputs[2].colormap.stops.size() == 2);
}

TEST_CASE("maps stand beside pictures: the first output of colours is the first picture") {
    const Experiment e = parsed_on_grid(
        "output U normal -2.5\noutput V height range 1 3\noutput V range each\noutput U\noutput U height\n");
    const Experiment alone = parsed_on_grid("colormap select gradient\noutput V height");
    const Experiment cells = parsed("define chemical U\ncreate hex_grid 3 3\noutput U height\ntexture size 8 8\n");

    REQUIRE(e.outputs.size() == 5);
    CHECK(e.outputs[0].drawing == Drawing::normal);
    CHECK(e.outputs[0].strength == -2.5);
    CHECK(e.outputs[1].drawing == Drawing::height);
    CHECK(e.outputs[1].range == std::array<double, 2>{1.0, 3.0});
    CHECK(e.outputs[2].drawing == Drawing::colours);
    CHECK(e.outputs[2].own_range);
    CHECK_FALSE(e.outputs[3].own_range);
    REQUIRE(alone.outputs.size() == 2);
    CHECK(alone.outputs[0].drawing == Drawing::colours);
    CHECK(alone.outputs[0].colormap.name == "gradient");
    CHECK(alone.outputs[1].drawing == Drawing::height);
    CHECK(cells.outputs.size() == 2);
}

TEST_CASE("named colour maps") {
    for (const std::string name : {"heat", "inferno", "viridis", "magma", "gray"}) {
        CHECK(parsed_on_grid("colormap select " + name).outputs.at(0).colormap.name == name);
    }
}

TEST_CASE("texture and zoom") {
    const Experiment e = parsed_on_grid("texture size 512 256\nzoom level 1.303\n");

    CHECK(e.texture == std::array<std::size_t, 2>{512, 256});
    CHECK(e.zoom == 1.303);
    CHECK_FALSE(parsed_on_grid("").texture.has_value());
    CHECK(parsed_on_grid("").zoom == 1.0);
}
