// What the command says when the OpenCL loader meets drivers that cannot be loaded.
#include "support/process.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Contains;
using test::command;
using test::Folder;
using test::Outcome;

namespace {

const std::string spots =
    "define chemical U\nuse chemical U conc 4 dev 0.5 diff 0.1\ncreate matrix 6 5 wrap\nstop at 4\n";

std::string good_driver() {
    const std::string file = "/etc/OpenCL/vendors/pocl.icd";
    return std::filesystem::exists(file) ? test::read_all(file) : "";
}

}  // namespace

TEST_CASE("drivers that cannot be loaded leave the reference, and an answer to who wants a device") {
    const Folder folder;
    std::filesystem::create_directory(folder / "drivers");
    folder.write("drivers/missing.icd", "/nowhere/libno-such-driver.so\n");
    folder.write("drivers/nonsense.icd", folder.write("drivers/nonsense.so", "no shared object") + "\n");
    folder.write("drivers/empty.icd", "");
    folder.write("drivers/other.icd", "libm.so.6\n");
    test::Surroundings broken;
    broken.environment["OCL_ICD_VENDORS"] = folder / "drivers";
    const std::string file = folder.write("spots.pex", spots);

    const Outcome listed = command({"devices"}, broken);
    const Outcome free = command({"run", file, "--out", folder / "free"}, broken);
    const Outcome bound = command({"run", file, "--out", folder / "bound", "--backend", "opencl"}, broken);

    CHECK(listed.exit_code == 0);
    CHECK_THAT(listed.out, Contains("No OpenCL device"));
    INFO(free.err);
    CHECK(free.exit_code == 0);
    CHECK_THAT(free.err, Contains("backend: reference") && Contains("not opencl: no OpenCL device is there"));
    INFO(bound.err);
    CHECK(bound.exit_code == 2);
    CHECK_THAT(bound.err, Contains("pelage: no OpenCL device is there; install a driver"));
    CHECK_FALSE(std::filesystem::exists(folder / "bound"));
}

TEST_CASE("a driver that cannot be loaded does not hide one that can") {
    if (good_driver().empty()) {
        WARN("SKIPPED: PoCL is not installed as /etc/OpenCL/vendors/pocl.icd");
        return;
    }
    const Folder folder;
    std::filesystem::create_directory(folder / "drivers");
    folder.write("drivers/a.icd", "/nowhere/libno-such-driver.so\n");
    folder.write("drivers/b.icd", good_driver());
    test::Surroundings mixed;
    mixed.environment["OCL_ICD_VENDORS"] = folder / "drivers";
    const std::string file = folder.write("spots.pex", spots);

    const Outcome listed = command({"devices", "--json", folder / "devices.json"}, mixed);
    const Outcome ran = command({"run", file, "--out", folder / "out", "--backend", "opencl"}, mixed);

    CHECK(listed.exit_code == 0);
    CHECK(nlohmann::json::parse(test::read_all(folder / "devices.json")).at("devices").size() == 1);
    INFO(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.err, Contains("backend: opencl"));
}
