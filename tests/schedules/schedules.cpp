// Kernels whose work-groups and work-items come in other orders than usual, late, and on another number of threads than
// there are processors (PELAGE_SCHEDULE): the same bits. A wait or a barrier less, and they are not.
#include "support/form.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

using Catch::Contains;
using namespace test;

namespace {

struct Way {
    std::string schedule;  // empty: the usual one
    int threads = 1;
};

Surroundings surroundings_of(const Way& way) {
    Surroundings surroundings;
    surroundings.patience = std::chrono::minutes(15);
    surroundings.environment = {{"PELAGE_SCHEDULE", way.schedule},
                                {"POCL_MAX_PTHREAD_COUNT", std::to_string(way.threads)}};
    return surroundings;
}

// The long form takes all that PoCL starts for up to eight processors, and more orders.
std::vector<Way> ways() {
    if (!long_form()) return {{"reverse", 3}, {"random:1", 8}};
    std::vector<Way> all;
    for (int threads = 1; threads <= 8; ++threads) {
        all.push_back({"reverse", threads});
        for (const char* drawn : {"random:1", "random:2", "random:3"}) all.push_back({drawn, threads});
    }
    return all;
}

Outcome verify(const Way& way, const std::string& filter, const std::filesystem::path& kernels = {}) {
    const Folder folder;
    Surroundings surroundings = surroundings_of(way);
    if (!kernels.empty()) surroundings.environment["PELAGE_KERNELS"] = kernels.string();
    return command({"verify", "--jobs", "1", "--filter", filter, "--evidence", folder / "evidence"}, surroundings);
}

void same_bits(const std::string& filter) {
    for (const Way& way : ways()) {
        const Outcome outcome = verify(way, filter);

        INFO(way.schedule << " on " << way.threads << " threads: " << outcome.out << outcome.err);
        CHECK(outcome.exit_code == 0);
        CHECK_THAT(outcome.out, Contains(", 0 differ;"));
        CHECK_THAT(outcome.err, Contains("note: work is done in the order of PELAGE_SCHEDULE, '" + way.schedule));
    }
}

// Whether the checks see it where `text`, in a kernel's file, reads `instead`.
bool seen(const Way& way, const std::string& filter, const std::string& file, const std::string& text,
          const std::string& instead) {
    const Folder folder;
    const auto kernels = folder / "kernels";
    std::filesystem::copy(std::filesystem::path(PELAGE_SOURCE) / "kernels", kernels,
                          std::filesystem::copy_options::recursive);
    std::string source = read_all(kernels / file);
    const auto at = source.find(text);
    REQUIRE(at != std::string::npos);
    folder.write("kernels/" + file, source.replace(at, text.size(), instead));
    const Outcome outcome = verify(way, filter, kernels);
    INFO(outcome.out << outcome.err);
    REQUIRE((outcome.exit_code == 0 || outcome.exit_code == 1));
    CHECK_THAT(outcome.out, Contains(" cells compared, "));
    return outcome.exit_code == 1;
}

const char* const strips = "sizes/strips";

}  // namespace

TEST_CASE("strips that share steps and passes give the same bits in every order, late and on any number of threads") {
    same_bits(strips);
}

TEST_CASE("tiles give the same bits in every order") { same_bits("tiled/diffusion/own-weights/no-flux"); }

TEST_CASE("scan and sort give the same bits in every order") {
    same_bits("scan/");
    same_bits("sort/");
}

TEST_CASE("the neighbour search gives the same lists in every order") { same_bits("neighbours/special"); }

TEST_CASE("free cells that one work-group carries on give the same bits in every order") {
    same_bits("cells/at-one-place");
}

TEST_CASE("charges that one work-group adds give the same bits in every order") { same_bits("aggregates/"); }

TEST_CASE("a strip that does not wait for the one below is seen, however few processors there are") {
    CHECK(seen({"reverse", 3}, strips, "lattice/together.cl", "flags[DONE(below)] >= level && ", ""));
    CHECK(seen({"random:1", 8}, strips, "lattice/together.cl", " && flags[DONE(above)] >= level;", ";"));
}

TEST_CASE("what is no schedule is refused with what may be one") {
    for (const char* wrong :
         {"backward", "reverse ", "random", "random:", "random:-1", "random:1x", "random:4294967296"}) {
        const Outcome outcome = command({"devices"}, surroundings_of({wrong, 1}));

        CHECK(outcome.exit_code == 2);
        CHECK(outcome.err == "pelage: PELAGE_SCHEDULE is '" + std::string(wrong) +
                                 "'; it may be 'reverse', or 'random:' and a whole number from 0 to 4294967295\n");
    }
}
