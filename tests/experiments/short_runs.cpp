// Every experiment that comes with the program parses, names what it shows, and runs on both backends with equal bits.
#include "core/prepattern.hpp"
#include "experiments/files.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <regex>

using namespace pelage;

namespace {

// A few iterations on both backends from `start`, as if everything before had changed nothing. True when the
// iterations changed something.
bool run_briefly(const Experiment& experiment, Backend& reference, Backend& device, std::uint64_t start) {
    Snapshot before = initial_state(experiment);
    before.iteration = start;
    const auto expected = reference.make_tissue(experiment, before);
    const auto found = device.make_tissue(experiment, before);
    expected->write(before);
    found->write(before);

    expected->advance(3);
    found->advance(3);

    const Snapshot after = expected->read();
    const std::vector<std::string> lines = verify::differences(after, found->read());
    INFO("from iteration " << start << ": " << fmt::format("{}", fmt::join(lines, "\n  ")));
    REQUIRE(lines.empty());
    return !verify::differences(before, after).empty();
}

// Part `part` of four, so that test runners can do them side by side.
void run_part(std::size_t part) {
    const auto reference = reference_backend(Precision::single_);
    const auto device = opencl_backend();
    const std::vector<std::filesystem::path> files = test::experiment_files();
    REQUIRE(files.size() > 4);
    for (std::size_t i = part; i < files.size(); i += 4) {
        INFO(files[i].filename().string());
        const Experiment experiment = parse_experiment_file(files[i]);
        REQUIRE(device->why_not(experiment).empty());
        bool moved = false;
        for (const std::uint64_t start : test::beginnings(experiment)) {
            moved = run_briefly(experiment, *reference, *device, start) || moved;
        }
        REQUIRE(moved);
    }
}

}  // namespace

TEST_CASE("every experiment parses and names its source and figure in the first line") {
    const std::regex named(
        "// (Malheiros.* (2017|2020), figure|McConnell 2024, appendix, preset|Girgin & Sacan).+: .+");

    for (const auto& file : test::experiment_files()) {
        INFO(file.filename().string());
        REQUIRE(std::regex_match(test::first_line(file), named));
        const Experiment experiment = parse_experiment_file(file);
        REQUIRE_FALSE(experiment.outputs.empty());
        REQUIRE(experiment.last_iteration() > 0);
    }
}

TEST_CASE("every published result that is promised has its file") {
    const std::vector<std::string> wanted{"leopard",
                                          "unbounded-spots",
                                          "unbounded-labyrinth",
                                          "bounded-upper",
                                          "bounded-lower",
                                          "bounded-both",
                                          "comparison-of-growth",
                                          "whipray-reticulate",
                                          "whipray-honeycomb",
                                          "frog",
                                          "squirrel",
                                          "cow",
                                          "dalmatian",
                                          "wild-dog",
                                          "giraffe",
                                          "nudibranch",
                                          "poison-dart-frog",
                                          "moray-eel",
                                          "gradients",
                                          "anisotropic-rays",
                                          "anisotropic-rings",
                                          "modulation",
                                          "game-of-life",
                                          "wireworld",
                                          "laplacian-growth",
                                          "gray-scott-mitosis",
                                          "gray-scott-maze",
                                          "gray-scott-waves",
                                          "gray-scott-spirals",
                                          "gray-scott-ocean",
                                          "cascade-cheetah",
                                          "cascade-leopard",
                                          "growth-front",
                                          "growth-centre",
                                          "growth-border",
                                          "growth-branching",
                                          "growth-uniform",
                                          "growth-frozen",
                                          "growth-reinforced",
                                          "leopard-of-cells"};

    std::set<std::string> there;
    for (const auto& file : test::experiment_files()) there.insert(file.stem().string());

    for (const std::string& name : wanted) {
        INFO(name);
        CHECK(there.contains(name));
    }
}

TEST_CASE("experiments start with equal bits on both backends, first quarter") { run_part(0); }
TEST_CASE("experiments start with equal bits on both backends, second quarter") { run_part(1); }
TEST_CASE("experiments start with equal bits on both backends, third quarter") { run_part(2); }
TEST_CASE("experiments start with equal bits on both backends, last quarter") { run_part(3); }
