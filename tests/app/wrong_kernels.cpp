// Kernels that are wrong in one word, read from a folder: `pelage verify` fails, and names the word.
#include "support/process.hpp"
#include "verify/array_factors.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>

using Catch::Contains;
using pelage::verify::Realm;
using test::Folder;
using test::Outcome;

namespace {

// The first generated check whose program is soon compiled, and in whose rules that factor has the value.
std::string check_with(Realm realm, const char* factor, const std::string& value) {
    for (const pelage::verify::GeneratedWorld& world : pelage::verify::generated_worlds(realm, 2)) {
        const auto has = [&](const pelage::verify::ArrayRow& rule) {
            return pelage::verify::Values(realm, rule)[factor] == value;
        };
        if (pelage::verify::Values(realm, world.world)["path"] != "step" || std::ranges::none_of(world.rules, has))
            continue;
        const char* const kind = realm == Realm::lattice ? "lattice" : "cells";
        return "pairs/" + std::string(kind) + "/" + std::to_string(world.number) + "-";
    }
    FAIL("no generated world has " << value);
    return "";
}

// What the generated experiments with that in their names say where `text` in a kernel's file reads `instead`.
Outcome with_fault(const std::string& file, const std::string& text, const std::string& instead,
                   const std::string& checks) {
    const Folder folder;
    const auto kernels = folder / "kernels";
    std::filesystem::copy(std::filesystem::path(PELAGE_SOURCE) / "kernels", kernels,
                          std::filesystem::copy_options::recursive);
    std::string source = test::read_all(kernels / file);
    const auto at = source.find(text);
    REQUIRE(at != std::string::npos);
    folder.write("kernels/" + file, source.replace(at, text.size(), instead));
    test::Surroundings busy;
    busy.patience = std::chrono::seconds(300);
    busy.environment["PELAGE_KERNELS"] = kernels.string();
    busy.environment["POCL_EXTRA_BUILD_FLAGS"] = "-cl-opt-disable";  // the fault shows there, too, in half the time
    return test::command({"verify", "--filter", checks, "--evidence", folder / "evidence"}, busy);
}

}  // namespace

TEST_CASE("a model with a wrong sign is named") {
    const Outcome outcome =
        with_fault("models/gm1.cl", "u * u - v", "u * u + v", check_with(Realm::cells, "action", "react gm1"));
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("this is enough to make it differ:\n") && Contains(" gm1 a "));
}

TEST_CASE("a quantity that is another is named") {
    const Outcome outcome = with_fault("lattice/step.cl", "#define WHOLE_ROW ((uint)row)",
                                       "#define WHOLE_ROW ((uint)x)", check_with(Realm::lattice, "amount", "ROW"));
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("this is enough to make it differ:\n") && Contains(" ROW"));
}

TEST_CASE("an action that acts otherwise is named") {
    const Outcome outcome = with_fault("cells/step.cl", "new_y + py * offset", "new_y - py * offset",
                                       check_with(Realm::cells, "action", "move"));
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("this is enough to make it differ:\n") && Contains(" move "));
}

TEST_CASE("what is made of a subnormal number is it or 0") {
    const Outcome outcome = with_fault("common/subnormal.cl", "1.0f : 0.0f", "2.0f : 0.01f", "device/subnormal");
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("comparisons of subnormal numbers gave "));
}
