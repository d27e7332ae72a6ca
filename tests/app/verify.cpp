// `pelage verify` as a user calls it: verdicts, files, exit codes, and drivers that crash or hang.
#include "support/process.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <nlohmann/json.hpp>

#include <csignal>
#include <map>
#include <regex>
#include <set>
#include <sstream>

using Catch::Contains;
using test::Child;
using test::child_of;
using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;

namespace {

// What becomes of a check whose process is sent that signal.
Outcome disturbed(const Folder& folder, int signal) {
    Child child({PELAGE_COMMAND, "verify", "--filter", "neighbours/many", "--full", "--jobs", "1", "--limit", "2",
                 "--json", folder / "report.json"});
    const pid_t worker = child_of(child.id(), "--worker");
    REQUIRE(worker != 0);
    kill(worker, signal);
    return child.wait();
}

}  // namespace

// The whole quick form: conformance_long/forms.cpp.
TEST_CASE("verify finds nothing wrong with this device in a share of the generated lattices, and reports") {
    const Folder folder;

    test::Surroundings busy;  // a quarter of a minute, or several where others compile, too
    busy.patience = std::chrono::seconds(600);
    const Outcome outcome = command(
        {"verify", "--filter", "pairs/lattice/1", "--json", folder / "report.json", "--html", folder / "report.html"},
        busy);

    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("KERNEL") && Contains("tiled steps") && Contains("VERDICT"));
    const auto report = nlohmann::json::parse(read_all(folder / "report.json"));
    for (const char* key : {"device", "driver", "platform", "build_options", "version", "seed"}) {
        CHECK(report.contains(key));
    }
    const auto& summary = report.at("summary");
    CHECK(summary.at("failed") == 0);
    CHECK(summary.at("mistrusted") == 0);
    CHECK(summary.at("cells_differing") == 0);
    CHECK(summary.at("max_ulp") == 0);
    CHECK(summary.at("verdict") == "passed");
    CHECK(summary.at("cases") == report.at("cases").size());
    CHECK(summary.at("cells_compared").get<std::uint64_t>() > 100'000);
    CHECK_THAT(read_all(folder / "report.html"), Contains("</html>"));
}

TEST_CASE("verify finds nothing wrong with this device in a share of the generated tissues") {
    test::Surroundings busy;
    busy.patience = std::chrono::seconds(600);

    const Outcome outcome = command({"verify", "--filter", "pairs/cells/1"}, busy);

    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("generated cells"));
}

TEST_CASE("verify with a filter runs only what bears that name, in the same way each time") {
    const Folder folder;
    const auto run = [&](const std::string& name) {
        REQUIRE(command({"verify", "--filter", "random/", "--seed", "5", "--json", folder / name}).exit_code == 0);
        return nlohmann::json::parse(read_all(folder / name)).at("cases");
    };

    const auto first = run("a.json");
    const auto second = run("b.json");

    REQUIRE(first.size() == 2);
    CHECK(first[0].at("name") == "random/known-answers");
    CHECK(first[1].at("fingerprint") == second[1].at("fingerprint"));
}

TEST_CASE("verify on all devices compares them") {
    const Outcome outcome = command({"verify", "--device", "all", "--filter", "random/known-answers"});

    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("passed:"));
}

TEST_CASE("verify --list names the checks of a form") {
    const Outcome quick = command({"verify", "--list"});
    const Outcome full = command({"verify", "--list", "--full"});

    CHECK(quick.exit_code == 0);
    CHECK_THAT(quick.out, Contains("diffusion/nine-point/wrap") && Contains("streamed/"));
    CHECK(full.out.size() > 2 * quick.out.size());
}

TEST_CASE("the checks that the page on verification names are there") {
    std::set<std::string> names, kinds;
    std::istringstream lists(command({"verify", "--list"}).out + command({"verify", "--list", "--full"}).out);
    for (std::string line; std::getline(lists, line);) {
        const std::string name = line.substr(line.rfind(' ') + 1);
        names.insert(name);
        kinds.insert(name.substr(0, name.find('/')));
    }
    const std::string page = read_all(PELAGE_SOURCE "/docs/verification.md");
    const std::regex quoted("`([a-z0-9-]+)(/[a-z0-9/-]*[a-z0-9])`");
    std::vector<std::string> unknown;
    std::size_t named = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), quoted); at != std::sregex_iterator(); ++at) {
        if (!kinds.contains((*at)[1])) continue;
        ++named;
        const std::string name = (*at)[1].str() + (*at)[2].str();
        if (!names.contains(name)) unknown.push_back(name);
    }
    CAPTURE(unknown);
    CHECK(unknown.empty());
    CHECK(named > 100);
}

TEST_CASE("verify says what it cannot do") {
    const Folder folder;
    const Outcome nothing = command({"verify", "--filter", "no such check"});
    const Outcome nowhere = command({"verify", "--device", "no such device"});

    CHECK(nothing.exit_code == 2);
    CHECK_THAT(nothing.err, Contains("no such check") && Contains("--list"));
    CHECK(nowhere.exit_code == 2);
    CHECK_THAT(nowhere.err, Contains("no such device"));
    CHECK(command({"verify", "--quick", "--full"}).exit_code == 2);
    CHECK(command({"verify", "--jobs", "0"}).exit_code == 2);
    CHECK(command({"verify", "--seed", "many"}).exit_code == 2);
    CHECK(command({"verify", "--filter", "random/known", "--json", folder.path()}).exit_code == 2);
}

TEST_CASE("verify tries the folder of its pictures before it begins, and leaves none that nothing is put into") {
    const Folder folder;

    const Outcome file = command({"verify", "--filter", "scan/", "--evidence", PELAGE_COMMAND});
    const Outcome good = command({"verify", "--filter", "scan/", "--evidence", folder / "a/b/"});

    CHECK(file.exit_code == 2);
    CHECK_THAT(file.err, Contains(PELAGE_COMMAND));
    CHECK(good.exit_code == 0);
    CHECK(test::names_in(folder.path()).empty());
}

TEST_CASE("verify says of which kernels its report is, and that there are none at once") {
    const Folder folder;
    test::Surroundings other, missing;
    other.environment = {{"PELAGE_KERNELS", PELAGE_SOURCE "/kernels"}};
    missing.environment = {{"PELAGE_KERNELS", folder / "none"}};

    const Outcome outcome =
        command({"verify", "--filter", "scan/", "--json", folder / "a.json", "--html", folder / "a.html"}, other);
    const Outcome nowhere = command({"verify", "--filter", "scan/"}, missing);

    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("Kernels came from PELAGE_KERNELS"));
    CHECK(nlohmann::json::parse(read_all(folder / "a.json")).at("kernels_folder") == PELAGE_SOURCE "/kernels");
    CHECK_THAT(read_all(folder / "a.html"), Contains("Kernels came from PELAGE_KERNELS"));
    CHECK(nowhere.exit_code == 2);
    CHECK_THAT(nowhere.err, Contains("cannot be read"));
}

TEST_CASE("verify that is stopped reports what it has checked") {
    const Folder folder;
    Child child({PELAGE_COMMAND, "verify", "--full", "--filter", "neighbours", "--jobs", "1", "--json",
                 folder / "report.json"});
    REQUIRE(child_of(child.id(), "--worker") != 0);

    kill(child.id(), SIGINT);

    const Outcome outcome = child.wait();
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 130);
    CHECK_THAT(outcome.out, Contains("A signal stopped it") && Contains("stopped: "));
    const auto report = nlohmann::json::parse(read_all(folder / "report.json"));
    CHECK(report.at("left_out").get<std::size_t>() > 0);
    CHECK(report.at("summary").at("verdict") == "stopped");
}

TEST_CASE("another seed draws other experiments, in which all agrees, too") {
    const Folder folder;
    const auto fingerprints = [&](const std::string& seed) {
        const Outcome outcome = command({"verify", "--filter", "fused", "--seed", seed, "--json", folder / seed});
        INFO(outcome.out << outcome.err);
        CHECK(outcome.exit_code == 0);
        std::map<std::string, std::string> found;
        const auto report = nlohmann::json::parse(read_all(folder / seed));
        for (const auto& one : report.at("cases"))
            found.emplace(one.at("name").get<std::string>(), one.at("fingerprint").get<std::string>());
        return found;
    };
    const auto usual = fingerprints("1"), other = fingerprints("77");
    CHECK(usual.at("rules/draws/fused") != other.at("rules/draws/fused"));
    CHECK(usual.at("reaction/fused") != other.at("reaction/fused"));
}

TEST_CASE("a check whose process dies has failed, and says how to run it alone") {
    const Folder folder;

    const Outcome outcome = disturbed(folder, SIGSEGV);

    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("neighbours/many: failed") && Contains("signal 11"));
    CHECK_THAT(outcome.out, Contains("verify --device") && Contains("--full") && Contains("--filter neighbours/many"));
    const auto report = nlohmann::json::parse(read_all(folder / "report.json"));
    CHECK(report.at("summary").at("verdict") == "failed");
}

TEST_CASE("a check that hangs is ended and has failed") {
    const Folder folder;

    const Outcome outcome = disturbed(folder, SIGSTOP);

    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("did not end within 2 seconds"));
}
