// What is said about results: sums, the table, JSON, the page, and unlike devices.
#include "verify/report.hpp"

#include "core/error.hpp"
#include "io/exr.hpp"
#include "verify/evidence.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>
#include <set>

using namespace pelage;
using namespace pelage::verify;
using Catch::Matchers::Contains;

namespace {

Result result(const std::string& name, Verdict verdict, std::uint64_t differing = 0) {
    Result made;
    made.name = name;
    made.kernel = name.substr(0, name.find('/'));
    made.verdict = verdict;
    made.cells_compared = 100;
    made.cells_differing = differing;
    made.max_ulp = differing * 2;
    made.fingerprint = "0123456789abcdef";
    return made;
}

Report report() {
    Report made;
    made.version = "1.2.3";
    made.form = "quick";
    DeviceReport device;
    device.device.name = "A <Device> & \"more\"";
    device.build_options = "-cl-std=CL1.2";
    device.results = {result("sort/a", Verdict::passed), result("diffusion/b", Verdict::failed, 7),
                      result("diffusion/c", Verdict::passed), result("scan/d", Verdict::skipped)};
    device.results[1].first = "conc[0] of cell 3 is 1 (0x3f800000), expected 2 (0x40000000)";
    device.results[1].max_relative = std::numeric_limits<double>::infinity();
    made.devices = {device};
    return made;
}

}  // namespace

TEST_CASE("one failure fails its kernel and the whole") {
    const Report whole = report();
    const std::vector<Summary> rows = by_kernel(whole.devices[0].results);

    REQUIRE(rows.size() == 3);
    CHECK(rows[0].verdict() == Verdict::passed);
    CHECK(rows[1].kernel == "diffusion");
    CHECK(rows[1].cases == 2);
    CHECK(rows[1].cells_differing == 7);
    CHECK(rows[1].verdict() == Verdict::failed);
    CHECK(rows[2].verdict() == Verdict::skipped);
    CHECK(total(report()).verdict() == Verdict::failed);
}

TEST_CASE("a mistrusted case is not passed") {
    REQUIRE(total({result("a/b", Verdict::passed), result("a/c", Verdict::mistrusted)}).verdict() ==
            Verdict::mistrusted);
}

TEST_CASE("the table has a line for each kernel") {
    REQUIRE_THAT(table(report().devices[0].results), Contains("diffusion                2          200          7"));
}

TEST_CASE("distances in units of the last place fit their column, and what is no number is said to be none") {
    CHECK(ulp_text(0) == "0");
    CHECK(ulp_text(99'999'999) == "99,999,999");
    CHECK(ulp_text(18'361'576'988'044'528'596u) == "1.8e+19");
    CHECK(ulp_text(std::numeric_limits<std::uint64_t>::max()) == "no number");
}

TEST_CASE("what a reader must know of a report is said in it") {
    Report report;
    CHECK(conditions(report).empty());
    CHECK(verdict_word(report) == std::string("skipped"));  // nothing was checked
    report.kernels = "elsewhere";
    report.left_out = 3;
    REQUIRE(conditions(report).size() == 2);
    CHECK_THAT(conditions(report)[0], Catch::Contains("PELAGE_KERNELS, 'elsewhere'"));
    CHECK_THAT(conditions(report)[1], Catch::Contains("3 checks were left out"));
    CHECK(verdict_word(report) == std::string("stopped"));
    CHECK_THAT(html(report), Catch::Contains("pelage verify: <span class=\"stopped\">"));
}

TEST_CASE("JSON holds device, version, seed, summary and cases") {
    const auto json = to_json(report());

    CHECK(json.at("version") == "1.2.3");
    CHECK(json.at("build_options") == "-cl-std=CL1.2");
    CHECK(json.at("seed") == 1);
    const auto& summary = json.at("summary");
    CHECK(summary.at("cases") == 4);
    CHECK(summary.at("passed") == 2);
    CHECK(summary.at("failed") == 1);
    CHECK(summary.at("mistrusted") == 0);
    CHECK(summary.at("cells_compared") == 400);
    CHECK(summary.at("cells_differing") == 7);
    CHECK(summary.at("max_ulp") == 14);
    CHECK(summary.at("verdict") == "failed");
    CHECK(json.at("cases").size() == 4);
    CHECK(json.at("cases")[1].at("max_relative") == "infinite");
}

TEST_CASE("results travel between processes unchanged") {
    const Report whole = report();
    for (Result before : whole.devices[0].results) {
        before.files = {"a/b.png"};
        before.seconds = 0.125;

        const Result after = result_from_json(nlohmann::ordered_json::parse(to_json(before).dump()));

        CHECK(to_json(after) == to_json(before));
        CHECK(after.verdict == before.verdict);
        CHECK(after.max_relative == before.max_relative);
    }
}

TEST_CASE("devices are compared case by case") {
    Report both = report();
    both.devices.push_back(both.devices[0]);
    both.devices[1].device.index = 1;
    REQUIRE(unlike(both).empty());

    both.devices[1].results[0].fingerprint = "fedcba9876543210";

    REQUIRE(unlike(both).size() == 1);
    REQUIRE_THAT(unlike(both)[0],
                 Contains("sort/a") && Contains("0123456789abcdef on 0") && Contains("fedcba9876543210 on 1"));
    REQUIRE(to_json(both).at("devices").size() == 2);
    REQUIRE(to_json(both).at("summary").at("cases") == 8);
}

TEST_CASE("the page is whole, needs no other file, and takes names literally") {
    const std::string page = html(report());

    CHECK_THAT(page, Contains("<!DOCTYPE html>") && Contains("</html>"));
    CHECK_THAT(page, Contains("A &lt;Device&gt; &amp; &quot;more&quot;"));
    CHECK_THAT(page, Contains("conc[0] of cell 3 is 1 (0x3f800000)"));
    CHECK(page.find("http") == std::string::npos);
}

TEST_CASE("evidence is kept as pictures of both sides and of the difference") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "pelage-evidence-test";
    std::filesystem::remove_all(folder);
    Evidence evidence{"conc[0]", 3, 2, {1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5.5, 6}};

    const auto files = keep_evidence(evidence, "diffusion/x/wrap", folder);

    REQUIRE(files.size() == 6);
    for (const auto& file : files) REQUIRE(std::filesystem::file_size(file) > 0);
    const ExrPicture difference = read_exr(folder / "diffusion-x-wrap.difference.exr");
    REQUIRE(difference.values[0] == std::vector<double>{0, 0, 0, 0, 0.5, 0});
    Report with = report();
    with.devices[0].results[1].files = files;
    REQUIRE_THAT(html(with), Contains("data:image/png;base64,iVBORw0KGgo"));
    std::filesystem::remove_all(folder);
}

TEST_CASE("checks have names of their own, and every kernel belongs to the quick form") {
    std::set<std::string> names;
    std::set<std::string> kernels;
    std::set<std::string> quick;
    for (const Check& check : all_checks(1)) {
        CAPTURE(check.name);
        CHECK(names.insert(check.name).second);
        kernels.insert(check.kernel);
        if (check.quick) quick.insert(check.kernel);
    }

    CHECK(quick.size() + 1 >= kernels.size());  // special values alone wait for the full form
    CHECK(names.size() > 100);
}

TEST_CASE("a check that throws has failed") {
    Place place({}, 1, false, false);
    const Check check{"a/b", "a", true, [](Place&) -> Outcome { throw Error("it broke"); }};

    const Outcome outcome = carry_out(check, place);

    REQUIRE(outcome.verdict == Verdict::failed);
    REQUIRE(outcome.message == "it broke");
}
