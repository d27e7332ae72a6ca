// `mpirun pelage sweep`: several processes share the tiles of one sweep.
#include "csv.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

using Catch::Contains;
using test::Child;
using test::Folder;
using test::Outcome;
using test::read_all;
using test::shell;
using test::without_times;

namespace {

const std::string map_text =
    "define parameter F 0.037\ndefine parameter K 0.06\ndefine chemical U limit 1\ndefine chemical V limit 1\n"
    "use seed 7\nuse chemical U conc 1 diff 0.2\nuse chemical V conc 0 dev 0.4 diff 0.1\ncreate matrix 32 32 wrap\n"
    "rule always react U V gray-scott f F k K\nstop at 3000\noutput V colormap viridis\n";

bool no_mpi() {
    const bool there = std::filesystem::exists(std::filesystem::path(test::program).parent_path() / "pelage-mpi.so") &&
                       shell("mpirun --version").exit_code == 0;
    if (!there) std::cout << "SKIPPED: Open MPI (libopenmpi-dev, openmpi-bin) is not there\n";
    return !there;
}

// Open MPI asks that root says twice that it is meant; these processes share the processors that there are. What Open
// MPI keeps until the end no stack tells: under a sanitizer nobody looks for leaks here.
std::string under_mpirun(int ranks, const std::string& words) {
    return "PELAGE_LEAKS_UNSEEN=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 exec mpirun "
           "--oversubscribe --bind-to none -n " +
           std::to_string(ranks) + " " + test::program + " " + words;
}

struct Cluster {
    std::string words(const std::string& out) const {
        return "sweep " + file + " --backend reference --jobs 1 --vary K=0.05:0.07:4 --vary F=0.02,0.04,0.05 --out " +
               (folder / out).string();
    }
    std::string csv(const std::string& out) const { return without_times(read_all(folder / (out + "/sweep.csv"))); }

    Folder folder;
    std::string file = folder.write("map.pex", map_text);
};

}  // namespace

TEST_CASE("two and four ranks leave the table that one process leaves") {
    if (no_mpi()) return;
    const Cluster bench;
    REQUIRE(shell(test::program + " " + bench.words("alone")).exit_code == 0);
    for (const int ranks : {2, 4}) {
        const std::string out = "ranks" + std::to_string(ranks);
        const Outcome outcome = shell(under_mpirun(ranks, bench.words(out)));
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        CHECK_THAT(outcome.out, Contains("12 tiles in"));
        CHECK(bench.csv(out) == bench.csv("alone"));
        CHECK(read_all(bench.folder / (out + "/sheet.png")) == read_all(bench.folder / "alone/sheet.png"));
    }
}

TEST_CASE("after a rank was killed the same command ends in the same table") {
    if (no_mpi()) return;
    const Cluster bench;
    const std::string longer = " --iterations 12000";  // so that not all tiles are done before the rank is found
    REQUIRE(shell(test::program + " " + bench.words("alone") + longer).exit_code == 0);
    {
        Child child({"sh", "-c", under_mpirun(2, bench.words("out") + longer)});
        REQUIRE(test::wait_for(bench.folder / "out/sweep.csv", child));
        const pid_t rank = test::child_of(child.id(), "sweep");
        REQUIRE(rank > 0);
        kill(rank, SIGKILL);
        CHECK(child.wait().exit_code != 0);
    }
    const auto rows = [&] { return std::ranges::count(bench.csv("out"), '\n'); };
    CHECK(rows() < 13);
    const Outcome again = shell(under_mpirun(2, bench.words("out") + longer));
    INFO(again.err);
    CHECK(again.exit_code == 0);
    CHECK_THAT(again.err, Contains("there already"));
    CHECK(bench.csv("out") == bench.csv("alone"));
}

TEST_CASE("what is wrong with a sweep of several ranks is said once") {
    if (no_mpi()) return;
    const Cluster bench;
    const Outcome outcome = shell(under_mpirun(3, bench.words("out") + " --vary Q=1,2"));
    CHECK(outcome.exit_code == 2);
    const std::string said = "defines no parameter of that name";
    const std::size_t first = outcome.err.find(said);
    REQUIRE(first != std::string::npos);
    CHECK(outcome.err.find(said, first + 1) == std::string::npos);
}
