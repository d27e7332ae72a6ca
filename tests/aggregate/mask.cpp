// Aggregates that grow where an expression or a picture lets them alone.
#include "core/aggregate.hpp"
#include "core/prepattern.hpp"
#include "io/npy.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "support/process.hpp"
#include "verify/compare.hpp"
#include "verify/self_test.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace pelage;

namespace {

// Walls from the lower to the upper edge with one door each, and a round pillar.
const std::string rooms = "(mod(COLUMN, 9) != 8 or ROW == mod(7 * COLUMN, 31)) and hypot(COLUMN - 13, ROW - 15) > 3";

Experiment masked(const std::string& where, const std::string& seed, const std::string& rule,
                  const std::string& size = "40 31") {
    return parse_experiment("define chemical order\ndefine chemical phi\ncreate charges " + size +
                                (where.empty() ? "" : " where (" + where + ")") + "\nset cells where (" + seed +
                                ") chemical order conc 1\nrule always aggregate order phi " + rule + "\n",
                            "masked.pex", ".");
}

std::vector<std::unique_ptr<Tissue>> on_all_paths(const Experiment& experiment) {
    std::vector<std::unique_ptr<Tissue>> tissues;
    tissues.push_back(reference_backend(Precision::double_)->make_tissue(experiment));
    for (const Path path : {Path::step, Path::shared}) {
        OpenclOptions options;
        options.path = path;
        tissues.push_back(opencl_backend(options)->make_tissue(experiment));
    }
    return tissues;
}

double charges_in(const Snapshot& state) {
    return static_cast<double>(std::ranges::count_if(state.conc[0], [](double order) { return order > 0.0; }));
}

void check_within(const Snapshot& state, const std::vector<double>& open) {
    for (std::size_t site = 0; site < open.size(); ++site) {
        if (open[site] != 0.0) continue;
        INFO("site " << site);
        REQUIRE(state.conc[0][site] == 0.0);
        REQUIRE(state.conc[1][site] == 0.0);
    }
}

std::string message_at_start(const Experiment& experiment) {
    try {
        (void)reference_backend(Precision::single_)->make_tissue(experiment);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "(none)";
}

}  // namespace

TEST_CASE("an aggregate grows on open sites alone until they are full, alike on both backends") {
    const Experiment experiment = masked(rooms, "COLUMN == 2 and ROW == 2", "eta 3");
    const auto reference = reference_backend(Precision::single_)->make_tissue(experiment);
    const std::vector<double> open = open_sites(experiment, reference->read());
    const auto others = on_all_paths(experiment);
    for (const std::uint64_t steps : std::vector<std::uint64_t>{1, 2, 300, 500, 400}) {
        reference->advance(steps);
        check_within(reference->read(), open);
        for (const auto& other : others) {
            other->advance(steps);
            INFO("iteration " << reference->iteration());
            REQUIRE(verify::differences(reference->read(), other->read()).empty());
        }
    }
    // All rooms hang together by their doors, and an iteration takes one site of them.
    const auto sites = static_cast<double>(open.size()) - static_cast<double>(std::ranges::count(open, 0.0));
    CHECK(sites < 1110.0);
    CHECK(charges_in(reference->read()) == sites);
}

TEST_CASE("what a mask shuts off is never reached, and a mask that holds everywhere changes nothing") {
    const Experiment shut = masked("COLUMN != 12", "COLUMN == 20 and ROW == 9", "eta 1");
    const Experiment open = masked("ROW >= 0", "COLUMN == 20 and ROW == 9", "eta 1");
    const Experiment plain = masked("", "COLUMN == 20 and ROW == 9", "eta 1");
    for (const auto& tissue : on_all_paths(shut)) {
        tissue->advance(40 * 31);
        CHECK(charges_in(tissue->read()) == 27.0 * 31.0);
    }
    const auto expected = reference_backend(Precision::single_)->make_tissue(plain);
    expected->advance(400);
    for (const auto& tissue : on_all_paths(open)) {
        tissue->advance(400);
        CHECK(verify::differences(expected->read(), tissue->read()).empty());
    }
}

TEST_CASE("a charge with no site to grow into stays alone") {
    for (const char* size : {"1 1", "9 7"}) {
        const Experiment experiment = masked("COLUMN == 0 and ROW == 0", "COLUMN == 0 and ROW == 0", "eta 2", size);
        for (const auto& tissue : on_all_paths(experiment)) {
            tissue->advance(5);
            const Snapshot state = tissue->read();
            CHECK(charges_in(state) == 1.0);
            CHECK(std::ranges::all_of(state.conc[1], [](double potential) { return potential == 0.0; }));
            tissue->write(state);
            tissue->advance(5);
            CHECK(verify::differences(state, tissue->read()).size() <= 1);  // the iteration
        }
    }
}

TEST_CASE("a mask may be a picture or drawn by the seed, and holds in a run that goes on") {
    const test::Folder folder;
    std::vector<double> pixels(40 * 31, 1.0);
    for (std::size_t at = 0; at < pixels.size(); at += 3) pixels[at] = 0.0;
    write_npy(folder / "walls.npy", {31, 40}, pixels);
    const Experiment pictured = parse_experiment(
        "define field walls \"walls.npy\"\ndefine chemical order\ndefine chemical phi\n"
        "create charges 40 31 at 2 3 where (walls > 0.5)\nset cell 1 chemical order conc 1\n"
        "rule always aggregate order phi eta 3\n",
        "pictured.pex", folder.path());
    const Experiment drawn =
        masked("RANDOM < 0.67 or ROW == 4", "ROW == 4 and COLUMN == 4", "eta 2 towards 0 30 strength 2");
    for (const Experiment* experiment : {&pictured, &drawn}) {
        const std::vector<double> open = open_sites(*experiment, initial_state(*experiment));
        CHECK(std::abs(static_cast<double>(std::ranges::count(open, 0.0)) - 413.0) < 50.0);
        for (const auto& tissue : on_all_paths(*experiment)) {
            tissue->advance(150);
            const Snapshot kept = tissue->read();
            tissue->advance(150);
            const Snapshot whole = tissue->read();
            CHECK(charges_in(whole) == 301.0);
            check_within(whole, open);
            tissue->write(kept);
            tissue->advance(150);
            CHECK(verify::differences(whole, tissue->read()).empty());
        }
    }
}

TEST_CASE("charges that start outside the mask are refused with its place") {
    CHECK(message_at_start(masked("COLUMN > 5", "ROW == 3 and COLUMN > 2", "eta 1")) ==
          "masked.pex:3:28: 3 charges on sites that 'where' leaves out, the first in column 3, row 3; charges start "
          "where it is true alone");
    CHECK(message_at_start(masked("COLUMN > 5", "ROW == 3 and COLUMN == 5", "eta 1")) ==
          "masked.pex:3:28: 1 charge on sites that 'where' leaves out, the first in column 5, row 3; charges start "
          "where it is true alone");
    CHECK_THAT(message_at_start(masked("COLUMN > 50", "RANDOM < 0", "eta 1")), Catch::Contains("no site holds"));
}

TEST_CASE("the self-test of a run knows masks, also where its piece of the lattice has no open site") {
    for (const char* where : {"hypot(X, Y) < 50", "COLUMN < 60", "hypot(COLUMN - 30, ROW - 30) < 20", "COLUMN > 90"}) {
        INFO(where);
        const Experiment experiment =
            masked(where, "COLUMN == 95 and ROW == 30 or COLUMN == 30 and ROW == 30", "eta 3", "120 61");
        Snapshot initial = initial_state(experiment);
        const std::vector<double> sites = open_sites(experiment, initial);
        for (std::size_t site = 0; site < sites.size(); ++site) {
            if (sites[site] == 0.0) initial.conc[0][site] = 0.0;
        }
        CHECK(verify::self_test({}, experiment, initial, 100).empty());
    }
}
