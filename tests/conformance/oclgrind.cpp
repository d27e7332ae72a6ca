// Kernels under Oclgrind: the reference's bits, no data race, no access outside of a buffer, nothing uninitialised; and
// faulty kernels (see faulty/) that show that it would have been seen.
#include "conformance/implementations.hpp"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

using Catch::Contains;
using namespace test;

namespace {

void nothing_to_report(const std::vector<std::string>& filters) {
    if (oclgrind_missing()) return;
    for (const std::string& filter : filters) {
        const Verification verification = verify({"--small", "--jobs", "1"}, under_oclgrind(), filter);

        require_equal_bits(verification);
        CHECK(verification.report["platform"] == "Oclgrind");
        CHECK(verification.process.err.empty());
        CHECK(verification.skipped().empty());
    }
}

// What Oclgrind says of the kernel in faulty/NAME.cl.
std::string report_of(const std::string& name) {
    const std::string file = PELAGE_SOURCE "/tests/conformance/faulty/" + name + ".cl";
    const Outcome outcome = Child({PELAGE_FAULTY_KERNEL, file}, under_oclgrind()).wait();
    REQUIRE(outcome.exit_code == 0);
    return outcome.err;
}

}  // namespace

TEST_CASE("Oclgrind has nothing to say about a kernel without a fault") {
    if (oclgrind_missing()) return;

    CHECK(report_of("none").empty());
}

TEST_CASE("Oclgrind names each kind of seeded fault") {
    if (oclgrind_missing()) return;

    CHECK_THAT(report_of("race_in_global_memory"),
               Contains("Write-write data race at global memory") && Contains("Kernel: faulty"));
    CHECK_THAT(report_of("race_in_local_memory"),
               Contains("Read-write data race at local memory") && Contains("Kernel: faulty"));
    CHECK_THAT(report_of("read_behind_the_end"),
               Contains("Invalid read of size 4 at global memory") && Contains("Kernel: faulty"));
    CHECK_THAT(report_of("write_before_the_beginning"),
               Contains("Invalid write of size 4 at global memory") && Contains("Kernel: faulty"));
    CHECK_THAT(report_of("read_of_what_nobody_wrote"),
               Contains("Uninitialized value written to global memory") && Contains("Kernel: faulty"));
}

TEST_CASE("a device that keeps subnormal numbers is found out, and told of") {
    if (oclgrind_missing()) return;

    for (const std::string check : {"device/subnormal", "values/denormal/published", "cells/near-zero"}) {
        const Verification verification = verify({"--small", "--jobs", "1"}, under_oclgrind(), check);

        INFO(verification.told());
        const nlohmann::json result = verification.result(check);
        REQUIRE(result.is_object());
        CHECK(result["verdict"] == "skipped");
        CHECK_THAT(result["message"].get<std::string>(),
                   Contains("keeps subnormal numbers (sums, products, fma") && Contains("2^-126"));
    }
    const Folder folder;
    folder.write("small.pex",
                 "define chemical A\nuse chemical A conc 1 dev 1 diff 0.1\ncreate matrix 5 4\nstop at 2\n");
    Surroundings surroundings = under_oclgrind();
    const Outcome run =
        command({"run", (folder / "small.pex").string(), "--out", (folder / "out").string()}, surroundings);
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.err, Contains("note: device") && Contains("keeps subnormal numbers"));
}

TEST_CASE("Oclgrind finds nothing in random numbers, sort and scan") {
    nothing_to_report({"random/", "scan/", "sort/"});
}

TEST_CASE("Oclgrind finds nothing in the neighbour search") { nothing_to_report({"neighbours/special"}); }

TEST_CASE("Oclgrind finds nothing in diffusion and in uneven and polarized rates") {
    nothing_to_report(
        {"diffusion/nine-point/wrap", "diffusion/published/wrap", "rates/uneven/published", "rates/polarized/five"});
}

TEST_CASE("Oclgrind finds nothing in reactions, rules and bounds") {
    nothing_to_report({"reaction/", "rules/chains", "saturation/"});
}

TEST_CASE("Oclgrind finds nothing in fused iterations and in growth") {
    nothing_to_report({"streamed/rules", "tiled/", "growth/", "laws/projection"});
}

TEST_CASE("Oclgrind finds nothing in batches, and takes tiles of a sweep in batches unasked, as any GPU") {
    nothing_to_report({"batch/rules/keeping"});
    if (oclgrind_missing()) return;
    const Folder folder;
    const std::string file =
        folder.write("map.pex",
                     "define parameter d 0.1\ndefine chemical U\nuse seed 3\nuse chemical U conc 1 dev 0.5 diff d\n"
                     "create matrix 12 9 wrap\nstop at 20\noutput U\n");
    Surroundings surroundings = under_oclgrind();  // its watchers know one thread alone, and a sweep has others
    surroundings.environment.erase("OCLGRIND_DATA_RACES");
    surroundings.environment.erase("OCLGRIND_UNINITIALIZED");
    const auto swept = [&](const std::string& out, const std::vector<std::string>& how) {
        std::vector<std::string> words{"sweep", file, "--vary", "d=0.1:0.3:4", "--jobs", "1", "--out", folder / out};
        words.insert(words.end(), how.begin(), how.end());
        const Outcome outcome = command(words, surroundings);
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        std::string table;
        std::istringstream lines(read_all(folder / (out + "/sweep.csv")));
        for (std::string line; std::getline(lines, line);) table += line.substr(0, line.rfind(',')) + "\n";
        return std::pair(table, outcome.err);
    };
    const auto [table, said] = swept("device", {"--backend", "opencl", "--no-self-test"});
    CHECK_THAT(said, Contains("up to 4 tiles of one structure together"));
    CHECK(table == swept("reference", {"--backend", "reference"}).first);
}

TEST_CASE("Oclgrind finds nothing in the steps of meshes") { nothing_to_report({"mesh/not-finite", "pairs/mesh/0-"}); }

TEST_CASE("Oclgrind finds nothing in the steps of free cells") {
    nothing_to_report({"cells/at-one-place", "cells/not-finite"});
}
