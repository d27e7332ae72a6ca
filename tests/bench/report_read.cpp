// A report that was written as JSON is read back whole; what is no report is refused with the reason.
#include "bench/report_read.hpp"

#include "bench/report.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/locked.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace pelage;
using namespace pelage::bench;

TEST_CASE("a report that is written and read back is the same") {
    const PrivateFolder folder(std::filesystem::temp_directory_path(), "pelage-test-");
    Report report;
    report.yardsticks = {{"host", "g++", "C++", 1e10, 2e11, 4096, 2}, {"device", "1.0", "PoCL", 2e10, 3e11, 8192, 4}};
    Result result;
    result.suite = "lattice";
    result.name = "turing";
    result.size = 100;
    result.backend = "opencl";
    result.device = "device";
    result.cells = 10'000;
    result.iterations = 7;
    result.seconds = 0.5;
    result.best = 0.25;
    result.bytes_per_cell = 12;
    report.results = {result};
    report.notes = {{"cells", "leopard", 5, "openmp", "host", "it was left out", true}};
    report.load = 0.125;
    const std::string text = json_of(report, Options{}, true).dump();
    write_file(folder.path() / "report.json", text);

    const Report found = read_report(folder.path() / "report.json");

    CHECK(json_of(found, Options{}, true).dump() == text);
}

TEST_CASE("what is no report is refused with the file and the reason") {
    const PrivateFolder folder(std::filesystem::temp_directory_path(), "pelage-test-");
    const auto refused = [&](const std::string& text) {
        write_file(folder.path() / "report.json", text);
        CHECK_THROWS_AS(read_report(folder.path() / "report.json"), Error);
    };

    refused("no JSON");
    refused("{}");
    refused(R"({"devices": [], "results": [], "notes": [], "load": 0})");
    refused(R"({"devices": [{"device": 3}], "results": [], "notes": [], "load": 0})");
    CHECK_THROWS_AS(read_report(folder.path() / "missing.json"), Error);
}
