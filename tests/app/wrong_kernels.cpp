// Kernels that are wrong in one word, read from a folder: `pelage verify` fails, and names the word.
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <string>

using Catch::Contains;
using test::Folder;
using test::Outcome;

namespace {

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
    return test::command({"verify", "--filter", checks, "--evidence", folder / "evidence"}, busy);
}

}  // namespace

TEST_CASE("a model with a wrong sign is named") {
    const Outcome outcome = with_fault("models/gm1.cl", "u * u - v", "u * u + v", "pairs/lattice/0-");
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("this is enough to make it differ:\n") && Contains(" gm1 a "));
}

TEST_CASE("a quantity that is another is named") {
    const Outcome outcome = with_fault("lattice/step.cl", "#define WHOLE_ROW ((uintv)((uint)row))",
                                       "#define WHOLE_ROW ((uintv)((uint)x))", "pairs/lattice/0-");
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("this is enough to make it differ:\n") && Contains(" ROW"));
}

TEST_CASE("an action that acts otherwise is named") {
    const Outcome outcome = with_fault("cells/step.cl", "new_y + py * offset", "new_y - py * offset", "pairs/cells/0-");
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("this is enough to make it differ:\n") && Contains(" move "));
}
