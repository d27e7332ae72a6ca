// Every experiment that comes with the program parses, names what it shows, and runs on both backends with equal bits.
#include "core/prepattern.hpp"
#include "experiments/files.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

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
        "// (Malheiros.* (2017|2020), (supplement's figure [0-9]|figures? [0-9]|no figure)|"
        "McConnell 2024, ((appendix,|its program's|no) preset|future work)|Pearson 1993, figure [0-9]|Mordvintsev et "
        "al. 2021, (no "
        "figure|figure "
        "[0-9])|Girgin & Sacan, figures? "
        "[0-9]).*: .+");

    for (const auto& file : test::experiment_files()) {
        INFO(file.filename().string());
        if (file.parent_path().filename() == "models") {
            CHECK(std::regex_search(test::remarks(file),
                                    std::regex("\\((1[6-9]|20)[0-9]{2}[,;)]|, (1[6-9]|20)[0-9]{2}\\)")));
        } else if (file.parent_path().filename() == "volume") {  // nobody's figures
            REQUIRE(std::regex_match(test::first_line(file), std::regex("// .+ in a volume: .+")));
        } else {
            REQUIRE(std::regex_match(test::first_line(file), named));
        }
        const Experiment experiment = parse_experiment_file(file);
        REQUIRE_FALSE(experiment.outputs.empty());
        REQUIRE(experiment.last_iteration() > 0);
    }
}

// Last figures as printed; the 2017 paper's supplement counts its own.
TEST_CASE("no experiment names a figure that its source does not have") {
    const std::vector<std::pair<std::regex, int>> last{{std::regex("Walter 2017, figure ([0-9]+)"), 16},
                                                       {std::regex("supplement's figure ([0-9]+)"), 25},
                                                       {std::regex("\\(([0-9]+) in the supplement\\)"), 25},
                                                       {std::regex("Walter 2020, figures? ([0-9]+)"), 22},
                                                       {std::regex("Sacan, figure ([0-9]+)"), 12}};

    for (const auto& file : test::experiment_files()) {
        const std::string line = test::first_line(file);
        for (const auto& [pattern, most] : last) {
            std::smatch found;
            if (!std::regex_search(line, found, pattern)) continue;
            INFO(file.filename().string());
            CHECK(std::stoi(found[1]) <= most);
        }
    }
}

TEST_CASE("docs/experiments.md has a row for every experiment, and for nothing else") {
    std::ifstream page(PELAGE_SOURCE "/docs/experiments.md");
    std::set<std::string> listed;
    for (std::string row; std::getline(page, row);) {
        if (!row.starts_with("| `")) continue;
        const std::string cell = row.substr(0, row.find('|', 1));
        const std::regex name("`([a-z0-9-]+)`");
        for (std::sregex_iterator one(cell.begin(), cell.end(), name), end; one != end; ++one) listed.insert((*one)[1]);
    }
    std::set<std::string> there;
    for (const auto& file : test::experiment_files()) there.insert(file.stem().string());

    CHECK(listed == there);
}

TEST_CASE("every published result that is promised has its file") {
    const std::string wanted =
        "leopard unbounded-spots unbounded-labyrinth bounded-both comparison-of-growth whipray-reticulate "
        "whipray-honeycomb frog squirrel cow dalmatian wild-dog giraffe nudibranch poison-dart-frog moray-eel "
        "gradients anisotropic-rays anisotropic-rings modulation game-of-life wireworld laplacian-growth "
        "gray-scott-mitosis gray-scott-maze gray-scott-waves gray-scott-spirals gray-scott-ocean cascade-cheetah "
        "cascade-leopard growth-front growth-centre growth-border growth-branching growth-uniform growth-frozen "
        "growth-reinforced leopard-of-cells division-normal division-shuffled division-triangular division-uniform "
        "frog-interpolated growing-lower growing-unbounded growing-upper growth-limited leopard-leg parameter-map "
        "saturated-random saturation-map static-lower static-unbounded static-upper turing-diffusion-rates "
        "turing-no-diffusion turing-no-reaction turing-noise turing-rate-and-diffusion turing-rate-and-noise "
        "turing-reaction-rate turing-ring turing-scales turing-spots";

    std::set<std::string> there;
    for (const auto& file : test::experiment_files()) there.insert(file.stem().string());

    std::istringstream names(wanted);
    for (std::string name; names >> name;) {
        INFO(name);
        CHECK(there.contains(name));
    }
}

TEST_CASE("experiments start with equal bits on both backends, first quarter") { run_part(0); }
TEST_CASE("experiments start with equal bits on both backends, second quarter") { run_part(1); }
TEST_CASE("experiments start with equal bits on both backends, third quarter") { run_part(2); }
TEST_CASE("experiments start with equal bits on both backends, last quarter") { run_part(3); }
