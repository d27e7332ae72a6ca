// Every published experiment at hand runs on both backends, lattices and free cells alike, to the same bits.
#include "core/error.hpp"
#include "core/seed.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "support/shared.hpp"
#include "verify/compare.hpp"

#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

using namespace pelage;

namespace {

constexpr std::uint64_t iterations = 12;
constexpr std::size_t shares = 4;  // test cases, so that they can run side by side

std::vector<std::filesystem::path> published_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::shared("pex"))) {
        // The misspelt one: its authors' program refuses it too.
        const bool misspelt = entry.path().stem() == "activation-18-automata-3";
        if (entry.path().extension() == ".pex" && !misspelt) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void check_share(std::size_t share) {
    if (test::shared_missing("pex")) return;
    const auto device = opencl_backend();
    const auto reference = reference_backend(Precision::single_);
    const std::vector<std::filesystem::path> files = published_files();
    REQUIRE(files.size() > shares);
    for (std::size_t i = share; i < files.size(); i += shares) {
        INFO(files[i].string());
        Experiment experiment = parse_experiment_file(files[i]);
        settle_seed(experiment);  // the same for both, where it is left to the clock
        REQUIRE(device->why_not(experiment).empty());
        const auto expected = reference->make_tissue(experiment);
        const auto found = device->make_tissue(experiment);

        expected->advance(iterations);
        found->advance(iterations);

        const std::vector<std::string> lines = verify::differences(expected->read(), found->read());
        INFO(fmt::format("{}", fmt::join(lines, "\n  ")));
        CHECK(lines.empty());
    }
}

}  // namespace

TEST_CASE("published experiments run on both backends, first share") { check_share(0); }
TEST_CASE("published experiments run on both backends, second share") { check_share(1); }
TEST_CASE("published experiments run on both backends, third share") { check_share(2); }
TEST_CASE("published experiments run on both backends, last share") { check_share(3); }
