// Numbers a user gives and gets: none is cut, rounded or read as another one.
#include "support/process.hpp"
#include "texts.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <set>
#include <string>

using Catch::Contains;
using test::command;
using test::Folder;
using test::read_all;

namespace {

// 0.3, a draw and 1/10 in 2 x 1 cells.
const std::string tenths =
    "define chemical A\n"
    "define chemical B\n"
    "use chemical A conc 0.3 diff 0.1\n"
    "use chemical B conc 4 dev 2\n"
    "create matrix 2 1\n"
    "stop at 0\n";

nlohmann::json manifest(const std::filesystem::path& folder) {
    return nlohmann::json::parse(read_all(folder / "manifest.json"));
}

}  // namespace

TEST_CASE("in double what is written keeps its digits, in the table too, and what is drawn is as in float") {
    const Folder folder;
    const std::string file = folder.write("tenths.pex", tenths);
    const std::string backend = GENERATE(as<std::string>(), "reference", "opencl");
    const auto table = [&](const std::string& precision) {
        const auto out = folder / (backend + precision);
        const auto outcome =
            command({"run", file, "--backend", backend, "--precision", precision, "--format", "csv", "--out", out});
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return read_all(std::filesystem::path(out) / "final.csv");
    };

    CHECK_THAT(table("float"), Contains("\n0,-1,0,0,0,0,0,0.300000012,5.3607"));
    CHECK_THAT(table("double"), Contains("\n0,-1,0,0,0,0,0,0.3,5.360751") && Contains(",0.1,0\n"));
}

TEST_CASE("every bit of a seed counts, and the clock's seed is another one at once") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    std::set<std::string> starts;
    std::set<std::int64_t> seeds;
    for (const std::string seed :
         {"1", "4294967296", "4294967297", "9223372036854775807", "-9223372036854775808", "0", "0", "0"}) {
        const auto outcome = command({"run", file, "--backend", "reference", "--iterations", "0", "--format", "npy",
                                      "--seed", seed, "--out", folder / "out"});
        REQUIRE(outcome.exit_code == 0);
        starts.insert(read_all(std::filesystem::path(folder / "out") / "final.U.npy"));
        seeds.insert(manifest(folder / "out").at("seed").get<std::int64_t>());
    }
    CHECK(starts.size() == 8);
    CHECK(seeds.size() == 8);
    CHECK(seeds.contains(4294967297));
}
