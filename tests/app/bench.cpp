// `pelage bench`: tiny sizes and short runs, what it writes, and how it refuses.
#include "support/process.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <csignal>
#include <set>
#include <string>

using Catch::Contains;
using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;

namespace {

// Other tests run beside these: threads shall not spin for a core that is not free.
test::Surroundings patient() {
    test::Surroundings surroundings;
    surroundings.environment["OMP_WAIT_POLICY"] = "passive";
    return surroundings;
}

std::set<std::string> backends_in(const nlohmann::json& report) {
    std::set<std::string> names;
    for (const auto& one : report.at("results")) names.insert(one.at("backend").get<std::string>());
    return names;
}

void check_results(const nlohmann::json& report, const std::string& suite) {
    REQUIRE_FALSE(report.at("results").empty());
    for (const auto& one : report.at("results")) {
        CHECK(one.at("suite") == suite);
        CHECK(one.at("case").is_string());
        CHECK(one.at("device").is_string());
        CHECK(one.at("size").get<std::size_t>() > 0);
        CHECK(one.at("cells").get<std::size_t>() > 0);
        CHECK(one.at("iterations").get<std::size_t>() > 0);
        CHECK(one.at("seconds").get<double>() > 0);
        CHECK(one.at("spread").get<double>() >= 0);
        CHECK(one.at("bandwidth_share").get<double>() > 0);
        const double work = one.at("cells").get<double>() * one.at("iterations").get<double>();
        CHECK(one.at("updates_per_second").get<double>() * one.at("seconds").get<double>() == Approx(work));
    }
    for (const auto& note : report.at("notes")) {
        INFO(note.dump());
        CHECK(note.at("wrong") == false);
    }
}

}  // namespace

TEST_CASE("bench compares and times the backends of a lattice, and writes JSON and plots") {
    const Folder folder;

    const Outcome outcome = command({"bench", "--suite", "lattice", "--cases", "turing", "--sizes", "20,33", "--quick",
                                     "--runs", "2", "--json", folder / "bench.json", "--plot", folder / "speed.png"},
                                    patient());

    INFO(outcome.err << outcome.out);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("M UPDATES/s") && Contains("TIMES FASTER") && Contains("COPY GB/s"));
    const auto report = nlohmann::json::parse(read_all(folder / "bench.json"));
    check_results(report, "lattice");
    CHECK(backends_in(report) ==
          std::set<std::string>{"reference", "openmp", "opencl-plain", "opencl-step", "opencl", "opencl-fast"});
    CHECK(report.at("results").size() == 12);
    CHECK(report.at("results")[0].at("cells") == 400);
    for (const char* key : {"version", "device", "driver"}) CHECK(report.at(key).is_string());
    CHECK(report.at("copy_bandwidth").get<double>() > 0);
    CHECK(report.at("peak").get<double>() > 0);
    CHECK(report.at("devices").size() == 2);
    CHECK(report.at("complete") == true);
    CHECK_FALSE(report.at("ratios").empty());
    for (const char* file : {"speed.roofline.png", "speed.scaling.png"}) {
        CHECK(read_all(folder / file).substr(0, 4) == "\x89PNG");
    }
    CHECK(test::names_in(folder.path()).size() == 3);
}

TEST_CASE("bench measures free cells and neighbours, against the named backends alone") {
    const Folder folder;

    const Outcome cells = command({"bench", "--suite", "cells", "--sizes", "200", "--against", "openmp", "--quick",
                                   "--runs", "2", "--json", folder / "cells.json"},
                                  patient());
    const Outcome points =
        command({"bench", "--suite", "neighbours", "--sizes", "300", "--against", "nanoflann,nanoflann-openmp",
                 "--quick", "--runs", "2", "--json", folder / "points.json"},
                patient());

    INFO(cells.err << points.err);
    REQUIRE(cells.exit_code == 0);
    REQUIRE(points.exit_code == 0);
    const auto of_cells = nlohmann::json::parse(read_all(folder / "cells.json"));
    const auto of_points = nlohmann::json::parse(read_all(folder / "points.json"));
    check_results(of_cells, "cells");
    check_results(of_points, "neighbours");
    CHECK(backends_in(of_cells) == std::set<std::string>{"openmp", "opencl"});
    CHECK(backends_in(of_points) == std::set<std::string>{"nanoflann", "nanoflann-openmp", "opencl"});
}

TEST_CASE("bench measures growth, and says which backend has no part in it") {
    const Folder folder;

    const Outcome outcome = command({"bench", "--suite", "growth", "--cases", "expansion", "--sizes", "16", "--quick",
                                     "--against", "openmp,opencl-plain", "--runs", "1", "--json", folder / "g.json"},
                                    patient());

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("left out: growth expansion 16, openmp: there is no hand-written baseline"));
    const auto report = nlohmann::json::parse(read_all(folder / "g.json"));
    REQUIRE(report.at("results").size() == 2);
    const auto& one = report.at("results")[0];
    const double seconds = one.at("seconds");
    CHECK(one.at("updates_per_second").get<double>() * seconds > 256.0 * one.at("iterations").get<double>());
}

TEST_CASE("a bench that is cut off keeps what it has measured") {
    const Folder folder;
    const std::filesystem::path file = folder / "bench.json";
    test::Child bench({PELAGE_COMMAND, "bench", "--suite", "neighbours", "--against", "nanoflann", "--quick", "--runs",
                       "1", "--sizes", "200,300,400,500,600,700,800,900", "--json", file},
                      patient());

    const bool appeared = test::wait_for(file, bench);
    const bool went_on = bench.running();
    bench.signal(SIGKILL);
    (void)bench.wait();

    CHECK(appeared);
    CHECK(went_on);
    const auto report = nlohmann::json::parse(read_all(file));
    check_results(report, "neighbours");
    CHECK(report.at("complete") == false);
}

TEST_CASE("bench --guard fails where a ratio is lost") {
    const Folder folder;
    const auto table = [&](const std::string& name, const std::string& ratio) {
        return folder.write(name, R"({"slack": 0.5, "ratios": [{"suite": "neighbours", "case": "hexagonal",)"
                                  R"( "size": 200, "against": "nanoflann", "ratio": )" +
                                      ratio + "}]}");
    };

    const Outcome kept =
        command({"bench", "--guard", table("easy.json", "0.0001"), "--quick", "--runs", "1"}, patient());
    const Outcome lost = command({"bench", "--guard", table("hard.json", "1e9"), "--quick", "--runs", "1"}, patient());
    const Outcome none = command({"bench", "--guard", folder.write("none.json", "{}")});

    CHECK(kept.exit_code == 0);
    CHECK_THAT(kept.out, Contains("kept"));
    CHECK(lost.exit_code == 1);
    CHECK_THAT(lost.out, Contains("LOST"));
    CHECK(none.exit_code == 2);
    CHECK_THAT(none.err, Contains("none.json") && Contains("slack"));
}

TEST_CASE("bench refuses what it does not know") {
    const Folder folder;
    const auto refused = [](std::vector<std::string> words, const std::string& reason) {
        words.insert(words.begin(), {"bench", "--quick"});
        const Outcome outcome = command(words);
        INFO(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_THAT(outcome.err, Contains(reason));
    };

    refused({"--suite", "cell"},
            "--suite 'cell' is unknown; there are: lattice, formula, cells, neighbours, growth, aggregate, volume, "
            "mesh, neural, all");
    refused({"--against", "openmp,cuda"}, "--against 'cuda' is unknown");
    refused({"--cases", "leopard"}, "--cases 'leopard' is unknown");
    refused({"--suite", "cells", "--cases", "turing"}, "--cases names none of suite 'cells'");
    refused({"--sizes", "0"}, "--sizes 0 is out of range");
    refused({"--sizes", "many"}, "--sizes");
    refused({"--runs", "0"}, "--runs 0 is out of range");
    refused({"--device", "no such device"}, "no such device");
    refused({"--json", "/proc/none/bench.json"}, "/proc/none");
    refused({"--guard", folder / "missing.json"}, "missing.json cannot be read");
}

TEST_CASE("the command links neither cairo nor X11: what draws plots is a program of its own") {
    const Outcome outcome = test::Child({"/usr/bin/ldd", PELAGE_COMMAND}).wait();

    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("libOpenCL") && !Contains("libcairo") && !Contains("libX11"));
}
