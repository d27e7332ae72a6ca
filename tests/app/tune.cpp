// `pelage tune`, and how `pelage run` takes what it found: tables, records, exit codes, candidates that crash or hang.
#include "support/process.hpp"
#include "texts.hpp"

#include "app/run_options.hpp"
#include "app/trial_worker.hpp"
#include "app/tune_table.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

using Catch::Contains;
using test::Child;
using test::command;
using test::Folder;
using test::names_in;
using test::Outcome;
using test::read_all;
using test::Surroundings;

namespace {

// Long enough for a run to look for what is remembered: 2.1 thousand million cell-updates.
const std::string long_run =
    "define chemical U limit 10\n"
    "define time_step 0.1\n"
    "use chemical U conc 4 dev 0.5 diff 0.1\n"
    "create matrix 512 512 wrap\n"
    "rule always change U conc 0.001\n"
    "stop at 8000\n";

Surroundings remembering_in(const Folder& folder) {
    Surroundings surroundings;
    surroundings.environment["PELAGE_CACHE"] = folder / "cache";
    return surroundings;
}

nlohmann::ordered_json json_in(const std::filesystem::path& file) {
    return nlohmann::ordered_json::parse(read_all(file));
}

std::filesystem::path record_in(const Folder& folder) {
    for (const std::string& name : names_in(folder / "cache")) {
        if (name.ends_with(".tuning")) return folder / "cache" / name;
    }
    FAIL("no record is there");
    return {};
}

// A quick search; on a busy machine it may take several until one has had time for the defaults.
Outcome search(const Folder& folder, const std::string& file, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"tune", file, "--quick", "--json", folder / "trials.json"};
    words.insert(words.end(), more.begin(), more.end());
    for (int attempt = 0;; ++attempt) {
        const Outcome outcome = command(words, remembering_in(folder));
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        if (json_in(folder / "trials.json").at("complete") == true) return outcome;
        REQUIRE(attempt < 10);
    }
}

// The record then says that a streamed candidate is twice as fast as all others, whatever was measured.
void favour_streaming(const std::filesystem::path& file) {
    auto record = json_in(file);
    for (auto& trial : record["trials"]) {
        if (trial["verdict"] == "good") trial["updates_per_second"] = 1e9;
    }
    auto favoured = record.at("trials").at(0);
    REQUIRE(favoured.at("verdict") == "good");
    favoured["updates_per_second"] = 2e9;
    favoured["candidate"] = {{"kernel", "streamed"}, {"width", 8}, {"depth", 12},
                             {"columns", 64},        {"rows", 8},  {"group", 0}};
    record["trials"].push_back(favoured);
    std::ofstream(file) << record.dump();
}

std::string manifest_tuning(const Folder& folder, const std::string& file, std::vector<std::string> more) {
    more.insert(more.begin(), {"run", file, "--backend", "opencl", "--format", "npy", "--out", folder / "out"});
    const Outcome outcome = command(more, remembering_in(folder));
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return json_in(folder / "out" / "manifest.json").at("tuning");
}

// A quick search whose first process is sent that signal.
Outcome disturbed(const Folder& folder, int signal, const std::vector<std::string>& more) {
    std::vector<std::string> words{PELAGE_COMMAND, "tune",   folder.write("spots.pex", test::spots),
                                   "--quick",      "--json", folder / "trials.json"};
    words.insert(words.end(), more.begin(), more.end());
    Child child(words, remembering_in(folder));
    const pid_t worker = test::child_of(child.id(), "--worker");
    REQUIRE(worker != 0);
    kill(worker, signal);
    return child.wait();
}

}  // namespace

TEST_CASE("tune prints a table, keeps a record, and remembers it until told to forget") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome first = search(folder, file);
    const auto record = json_in(folder / "trials.json");
    const Outcome second = search(folder, file);

    INFO(first.out << second.out);
    CHECK_THAT(first.out, Contains("RANK") && Contains("AGAINST DEFAULTS") && Contains("defaults"));
    CHECK_THAT(second.out, Contains("Remembered"));
    CHECK(record.at("exhaustive") == false);
    CHECK(record.at("trials").size() >= 1);
    CHECK(record.at("trials")[0].at("candidate").at("kernel") == "automatic");
    CHECK(record.at("key").at("size") == "32 x 16");
    CHECK(record == json_in(folder / "trials.json"));
    CHECK(record == json_in(record_in(folder)));

    const Outcome anew = search(folder, file, {"--forget", "--quiet"});

    CHECK(anew.out.empty());
    CHECK(anew.err.empty());
    CHECK(record != json_in(record_in(folder)));
}

TEST_CASE("a long run takes what was remembered for its class, to the same bits, unless told not to") {
    const Folder folder;
    const std::string file = folder.write("long.pex", long_run);
    const std::string other = folder.write("other.pex", "// The same class.\n" + long_run);
    search(folder, file, {"--quiet"});
    favour_streaming(record_in(folder));

    CHECK_THAT(manifest_tuning(folder, other, {}), Contains("streamed, width 8, depth 12"));
    const std::string tuned = read_all(folder / "out" / "final.U.npy");
    CHECK(manifest_tuning(folder, file, {"--no-tune"}) == "defaults");
    CHECK(tuned == read_all(folder / "out" / "final.U.npy"));
    CHECK(manifest_tuning(folder, file, {"--no-cache"}) == "defaults");
    CHECK(manifest_tuning(folder, file, {"--iterations", "10"}) == "defaults");
}

TEST_CASE("a candidate whose process dies is struck out, and stays so") {
    const Folder folder;

    const Outcome outcome = disturbed(folder, SIGSEGV, {});

    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("crashed: the process that tried it ended with signal 11"));
    CHECK_THAT(read_all(folder / "trials.json"), Contains("\"verdict\": \"crashed\""));
    const Outcome again = command({"tune", (folder / "spots.pex").string(), "--quick"}, remembering_in(folder));
    CHECK(again.exit_code == 1);
    CHECK_THAT(again.out, Contains("signal 11"));
}

TEST_CASE("a candidate that hangs is ended and struck out") {
    const Folder folder;

    const Outcome outcome = disturbed(folder, SIGSTOP, {"--limit", "1"});

    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains("hung: did not come to an end within 1 second"));
}

TEST_CASE("the limit of a candidate does not count its compilation") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome outcome = search(folder, file, {"--limit", "1", "--no-cache"});  // compiling takes longer

    CHECK_THAT(outcome.out, !Contains("hung"));
}

TEST_CASE("tune says that it could keep nothing, and why") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    Surroundings homeless;
    homeless.environment["PELAGE_CACHE"] = "/proc/nowhere";

    const Outcome without = command({"tune", file, "--quick"}, homeless);
    const Outcome no_cache = command({"tune", file, "--quick", "--no-cache"}, remembering_in(folder));

    INFO(without.out << no_cache.out);
    CHECK_THAT(without.out, Contains("nothing could be kept: ") && Contains("/proc/nowhere"));
    CHECK_THAT(no_cache.out, Contains("nothing could be kept: --no-cache"));
    CHECK_THAT(without.out, !Contains("will take"));
}

TEST_CASE("what befell several candidates is told once") {
    pelage::app::Tuning tuning;
    for (const std::size_t depth : {8u, 16u}) {
        pelage::tune::Trial trial;
        trial.candidate.cut.depth = depth;
        trial.verdict = pelage::tune::Verdict::hung;
        trial.message = "did not come to an end within 2 seconds";
        tuning.record.put(trial);
    }

    const std::string table = pelage::app::tuning_table(tuning, {});

    CHECK_THAT(table, Contains("2 candidates hung: did not come to an end within 2 seconds\n"));
    CHECK(table.find("did not come") == table.rfind("did not come"));
}

TEST_CASE("a long run says that it looks for a faster kernel before it does") {
    const Folder folder;
    const std::string file = folder.write("long.pex", long_run);
    Child child({PELAGE_COMMAND, "run", file, "--backend", "opencl", "--iterations", "400000", "--no-self-test",
                 "--out", folder / "out"},
                remembering_in(folder));
    REQUIRE(test::child_of(child.id(), "--worker") != 0);

    child.signal(SIGTERM);
    const Outcome outcome = child.wait();

    INFO(outcome.err);
    CHECK_THAT(outcome.err, Contains("tuning: a faster kernel is looked for, for 5 seconds at most"));
    CHECK_THAT(outcome.err, !Contains("Assertion"));
}

TEST_CASE("a search that is ended takes its child with it, without a word") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    Child child({PELAGE_COMMAND, "tune", file, "--no-cache"}, remembering_in(folder));
    const pid_t worker = test::child_of(child.id(), "--worker");
    REQUIRE(worker != 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(700));  // it compiles

    child.signal(SIGTERM);
    const Outcome outcome = child.wait();
    for (int i = 0; i < 1000 && kill(worker, 0) == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));

    CHECK(outcome.exit_code == 128 + SIGTERM);
    CHECK(kill(worker, 0) != 0);
    CHECK(outcome.err.empty());
}

TEST_CASE("a process that ends without an answer is a crash") {
    pelage::app::TrialWorker worker({"--libidentify"});

    const auto trial = worker.try_out({}, 30);

    REQUIRE(trial.has_value());
    CHECK(trial->verdict == pelage::tune::Verdict::crashed);
    CHECK_THAT(trial->message, Contains("exit code"));
}

TEST_CASE("tune says what it cannot do") {
    const Folder folder;
    const std::string lattice = folder.write("spots.pex", test::spots);
    const std::string cells = folder.write("cells.pex", "define chemical U\ncreate hex_circle 3\nstop at 10\n");

    const Outcome no_file = command({"tune", folder / "none.pex"});
    const Outcome free_cells = command({"tune", cells});
    const Outcome nowhere = command({"tune", lattice, "--device", "no such device"});

    CHECK(no_file.exit_code == 2);
    CHECK_THAT(no_file.err, Contains("none.pex"));
    CHECK(free_cells.exit_code == 2);
    CHECK_THAT(free_cells.err, Contains("free cells") && Contains("nothing to tune"));
    CHECK(nowhere.exit_code == 2);
    CHECK_THAT(nowhere.err, Contains("no such device"));
    CHECK(command({"tune"}).exit_code == 2);
    CHECK(command({"tune", lattice, "--precision", "half"}).exit_code == 2);
    CHECK(command({"tune", lattice, "--limit", "0"}).exit_code == 2);
    CHECK(command({"tune", lattice, "--quick", "--json", folder.path()}).exit_code == 2);
}

TEST_CASE("a resumed run keeps --no-tune") {
    pelage::app::RunOptions options;
    options.file = "spots.pex";
    options.no_tune = true;

    CHECK_THAT(pelage::app::resume_command(options, "c.pelage", 40, 1), Contains("--no-tune"));
    options.no_tune = false;
    CHECK_THAT(pelage::app::resume_command(options, "c.pelage", 40, 1), !Contains("--no-tune"));
}
