// The whole quick form on the device that a run would take, on rusticl and, in its smallest sizes, under Oclgrind.
#include "conformance/implementations.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>

using namespace test;
using Names = std::vector<std::string>;

namespace {

constexpr std::chrono::minutes patience{30};

// The functions of kernels/ that a host may launch.
std::set<std::string> all_kernels() {
    const std::regex function("(^|\n)(__)?kernel (__attribute__.*\\)\\) )?void ([a-z0-9_]+)\\(");
    std::set<std::string> names;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(PELAGE_SOURCE) / "kernels")) {
        if (entry.path().extension() != ".cl") continue;
        const std::string text = read_all(entry.path());
        for (auto at = std::sregex_iterator(text.begin(), text.end(), function); at != std::sregex_iterator(); ++at)
            names.insert((*at)[4].str());
    }
    return names;
}

std::set<std::string> lines_of(const std::filesystem::path& file) {
    std::istringstream lines(read_all(file));
    return {std::istream_iterator<std::string>(lines), {}};
}

// Who is never launched under Oclgrind, and why.
const std::set<std::string> not_launched{
    "pelage_copy", "pelage_multiply_add",  // of the benchmarks: every work-item has numbers of its own
    "pelage_lattice_means",                // on processors alone: likewise
};

// Oclgrind 21.10 takes a truth that fills a vector for 1 where all bits should be set. Compilers make one of a
// comparison of what all lanes share, such as `Y < -3.25`, when they optimize.
Surroundings under_oclgrind_as_written(const Folder& folder) {
    Surroundings surroundings = under_oclgrind();
    surroundings.patience = patience;
    surroundings.environment["PELAGE_CACHE"] = folder / "cache";  // none that an optimizer has seen
    surroundings.environment["OCLGRIND_BUILD_OPTIONS"] = "-cl-opt-disable";
    return surroundings;
}

// A step of learning has no small form. Oclgrind cannot interpret what its compiler makes of `restrict` where functions
// become part of others, and its watcher of values never initialised does not know all instructions of these kernels.
std::set<std::string> launched_by_learning() {
    Surroundings surroundings = under_oclgrind();
    surroundings.patience = patience;
    const Folder folder;
    surroundings.environment["PELAGE_LAUNCHED"] = folder / "launched";
    surroundings.environment["PELAGE_CACHE"] = folder / "cache";
    surroundings.environment["OCLGRIND_BUILD_OPTIONS"] = "-Drestrict=";
    surroundings.environment.erase("OCLGRIND_UNINITIALIZED");

    const Verification verification =
        verify({"--full", "--jobs", "1", "--limit", "1700"}, surroundings, "learning/one-rotation");

    require_equal_bits(verification);
    CHECK(verification.process.err.empty());
    return lines_of(folder / "launched");
}

}  // namespace

TEST_CASE("the usual device gives the reference's bits in the whole quick form") {
    Surroundings surroundings;
    surroundings.patience = patience;

    const Verification verification = verify({"--quick"}, surroundings);

    require_equal_bits(verification);
}

TEST_CASE("rusticl gives the reference's bits in the whole quick form") {
    if (rusticl_missing()) return;
    Surroundings surroundings = on_rusticl();
    surroundings.patience = patience;

    const Verification verification = verify({"--device", "llvmpipe", "--quick"}, surroundings);

    require_equal_bits(verification);
    for (const std::string& name : verification.skipped()) {
        const std::string message = verification.result(name)["message"];
        CHECK((name == "device/long-loop" || name == "neighbours/order" ||  // whose quotients are rounded correctly
               message == "the device has no numbers of double precision"));
    }
}

TEST_CASE("Oclgrind finds no race in the whole quick form nor in any kernel, and the reference's bits") {
    if (oclgrind_missing()) return;
    const Folder folder;
    Surroundings surroundings = under_oclgrind_as_written(folder);
    surroundings.environment["PELAGE_LAUNCHED"] = folder / "launched";
    surroundings.environment.erase("OCLGRIND_UNINITIALIZED");

    const Verification verification = verify({"--small", "--jobs", "2"}, surroundings);

    require_equal_bits(verification);
    CHECK(verification.process.err.empty());
    const std::vector<std::string> skipped = verification.skipped();
    std::set<std::string> chosen;  // generated ones whose sizes are all large are left out, too, and runs
    std::ranges::copy_if(skipped, std::inserter(chosen, chosen.end()), [](const std::string& name) {
        return !name.starts_with("pairs/") && !name.starts_with("courses/");
    });
    CHECK(chosen == std::set<std::string>{"device/subnormal", "neighbours/many", "neighbours/order",
                                          "values/denormal/published", "sizes/many-rows", "sizes/many-columns-around",
                                          "cells/near-zero", "cells/many", "aggregates/many", "aggregates/far-begun",
                                          "values/not-finite-far", "learning/rotations"});
    std::set<std::string> launched = lines_of(folder / "launched");
    launched.merge(launched_by_learning());
    const std::set<std::string> all = all_kernels();
    CHECK(all.size() > 50);
    std::set<std::string> others;
    std::ranges::set_difference(all, launched, std::inserter(others, others.end()));
    CHECK(others == not_launched);
}

// This watcher ends the process itself in some generated meshes.
TEST_CASE("Oclgrind finds no value that was never initialised in the whole quick form") {
    if (oclgrind_missing()) return;
    const Folder folder;
    Surroundings surroundings = under_oclgrind_as_written(folder);
    surroundings.environment.erase("OCLGRIND_DATA_RACES");

    const Verification verification = verify({"--small", "--jobs", "2", "--limit", "1700"}, surroundings);

    INFO(verification.told());
    REQUIRE(verification.report.is_object());
    CHECK(verification.process.err.empty());
    CHECK(verification.of("mistrusted").empty());
    for (const std::string& name : verification.of("failed")) {
        CHECK(name.starts_with("pairs/mesh/"));
        const std::string message = verification.result(name)["message"];
        CHECK(message.find("ended with signal 11") != std::string::npos);
    }
}
