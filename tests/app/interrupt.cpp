// Ctrl-C, checkpoints and going on from them.
#include "support/process.hpp"
#include "texts.hpp"

#include "io/checkpoint.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <csignal>

using test::Child;
using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;

namespace {

// The command that a stopped run printed on the line after "go on with:".
std::string printed_command(const std::string& text) {
    const auto mark = text.find("go on with:\n  ");
    REQUIRE(mark != std::string::npos);
    const auto begin = mark + 14;
    return text.substr(begin, text.find('\n', begin) - begin);
}

struct Case {
    std::string backend;
    std::string iterations;
    int signal;
};

}  // namespace

TEST_CASE("a run that is resumed without what its earlier pictures were drawn from says so") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const auto out = folder / "out";
    const auto run = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", file, "--backend", "reference", "--out", out, "--snap-every", "20"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = command(words);
        INFO(outcome.err);
        CHECK(outcome.exit_code == 0);
        return outcome.err;
    };
    (void)run({"--checkpoint-every", "50"});  // finished: the reel is gone
    const std::vector<std::string> resumed{"--resume", out / "checkpoint.pelage"};

    CHECK_THAT(run(resumed), Catch::Contains("warning: ") && Catch::Contains(".pelage-reel is missing or damaged") &&
                                 Catch::Contains("a range of colours that those to come do not share"));
    std::filesystem::remove_all(out / "0.png");
    CHECK_THAT(run({"--checkpoint-every", "50", "--format", "npy"}), !Catch::Contains("warning"));
    CHECK_THAT(run({"--resume", out / "checkpoint.pelage", "--format", "npy"}), !Catch::Contains("warning"));
}

TEST_CASE("Ctrl-C saves a checkpoint, and the command it prints ends in the bits of an uninterrupted run") {
    const Folder folder;
    const std::string file = folder.write("it's spots.pex", test::spots);
    const auto [backend, iterations, signal] = GENERATE(
        Case{"reference", "60000", SIGINT}, Case{"reference", "60000", SIGTERM}, Case{"reference", "20000", SIGHUP},
        Case{"reference", "20000", SIGXCPU}, Case{"opencl", "150000", SIGINT});
    const std::vector<std::string> common{"run",          file,       "--backend", backend,
                                          "--iterations", iterations, "--format",  "npy"};
    std::vector<std::string> words = common;
    words.insert(words.begin(), PELAGE_COMMAND);
    words.insert(words.end(), {"--out", folder / "broken off", "--checkpoint-every", "500"});

    Child child(words);
    REQUIRE(test::wait_for(folder / "broken off" / "checkpoint.pelage", child));
    child.signal(signal);
    const Outcome stopped = child.wait();

    INFO(stopped.err);
    REQUIRE(stopped.exit_code == 130);
    const auto reached = pelage::read_checkpoint(folder / "broken off" / "checkpoint.pelage").snapshot.iteration;
    CHECK(reached >= 500);
    CHECK(reached < std::stoull(iterations));
    CHECK(stopped.err.find("stopped at iteration " + std::to_string(reached)) != std::string::npos);
    const auto manifest = nlohmann::json::parse(read_all(folder / "broken off" / "manifest.json"));
    CHECK(manifest.at("end") == "interrupted");
    CHECK(manifest.at("iterations") == reached);

    const Outcome resumed = Child({"sh", "-c", printed_command(stopped.err)}).wait();
    std::vector<std::string> whole = common;
    whole.insert(whole.end(), {"--out", folder / "whole"});
    const Outcome uninterrupted = command(whole);

    INFO(resumed.err);
    REQUIRE(resumed.exit_code == 0);
    REQUIRE(uninterrupted.exit_code == 0);
    for (const char* name : {"final.U.npy", "final.V.npy"}) {
        CHECK(read_all(folder / "broken off" / name) == read_all(folder / "whole" / name));
    }
}

TEST_CASE("a signal before a run or a sweep begins ends it with a sentence") {
    const Folder folder;
    const std::string file = folder / "pipe.pex";
    REQUIRE(mkfifo(file.c_str(), 0600) == 0);
    const auto [subcommand, signal] =
        GENERATE(table<std::string, int>({{"run", SIGINT}, {"run", SIGTERM}, {"sweep", SIGTERM}}));
    std::vector<std::string> words{PELAGE_COMMAND, subcommand, file, "--out", folder / "out"};
    if (subcommand == "sweep") words.insert(words.end(), {"--vary", "a=1:2:2"});
    Child child(words);
    const int pipe = open(file.c_str(), O_WRONLY);  // waits until the experiment is being read
    child.signal(signal);
    const Outcome outcome = child.wait();
    close(pipe);
    CHECK(outcome.exit_code == 128 + signal);
    CHECK(outcome.err == "pelage: stopped before the " + subcommand + " began\n");
}

TEST_CASE("a run that was told to outlive its terminal does") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    Child child({"sh", "-c",
                 "trap '' HUP; exec " PELAGE_COMMAND " run " + file +
                     " --backend reference --iterations 5000 --checkpoint-every 500 --out " +
                     (folder / "out").string()});
    REQUIRE(test::wait_for(folder / "out" / "checkpoint.pelage", child));

    child.signal(SIGHUP);

    CHECK(child.wait().exit_code == 0);
    CHECK(std::filesystem::exists(folder / "out" / "final.exr"));
}

namespace {

// A run of `text` to iteration 60 that left a checkpoint at iteration 40.
std::filesystem::path checkpoint_at_40(const Folder& folder, const std::string& file) {
    const Outcome outcome = command({"run", file, "--backend", "reference", "--out", folder / "first", "--format",
                                     "npy", "--checkpoint-every", "20"});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    std::filesystem::path path = folder / "first" / "checkpoint.pelage";
    REQUIRE(pelage::read_checkpoint(path).snapshot.iteration == 40);
    return path;
}

}  // namespace

TEST_CASE(
    "option --checkpoint-every keeps the latest state, and a run resumed from it ends in the same bits on any "
    "backend") {
    const Folder folder;
    const std::string growing = test::spots +
                                "rule every 15 offset 2 always expand columns 1 rows 1\n"
                                "rule every 30 offset 19 always expand columns 2 rows 1 by bicubic\n";
    const std::string file = folder.write("spots.pex", growing);
    const std::filesystem::path checkpoint = checkpoint_at_40(folder, file);
    const std::string backend = GENERATE(as<std::string>(), "reference", "opencl");

    const Outcome outcome = command(
        {"run", file, "--backend", backend, "--out", folder / "second", "--format", "npy", "--resume", checkpoint});

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(read_all(folder / "first" / "final.U.npy") == read_all(folder / "second" / "final.U.npy"));
    const auto manifest = nlohmann::json::parse(read_all(folder / "second" / "manifest.json"));
    CHECK(manifest.at("first_iteration") == 40);
    CHECK(manifest.at("iterations") == 60);
    CHECK(manifest.at("cells") == (24 + 4 + 4) * (16 + 4 + 2));
}

TEST_CASE("a checkpoint of another run is refused with the difference") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::string checkpoint = checkpoint_at_40(folder, file);
    const auto resume = [&](const std::string& other, const std::vector<std::string>& more) {
        std::vector<std::string> words{"run",   other,        "--backend", "reference",
                                       "--out", folder / "b", "--resume",  checkpoint};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = command(words);
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };

    CHECK_THAT(resume(folder.write("other.pex", test::spots + "// edited\n"), {}),
               Catch::Contains("another experiment"));
    CHECK_THAT(resume(file, {"--precision", "double"}), Catch::Contains("--precision float"));
    CHECK_THAT(resume(file, {"--seed", "8"}), Catch::Contains("--seed 7"));
    CHECK_THAT(resume(file, {"--iterations", "39"}), Catch::Contains("iteration 40"));
    CHECK_FALSE(std::filesystem::exists(folder / "b"));
}

TEST_CASE("a truncated, corrupted or missing checkpoint is refused") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::string bytes = read_all(checkpoint_at_40(folder, file));
    std::string flipped = bytes;
    flipped[bytes.size() / 2] = static_cast<char>(flipped[bytes.size() / 2] ^ 1);
    const std::vector<std::string> bad{folder.write("short", bytes.substr(0, bytes.size() / 2)),
                                       folder.write("empty", ""),
                                       folder.write("flipped", flipped),
                                       file,
                                       folder / "missing",
                                       folder.path()};

    for (const std::string& checkpoint : bad) {
        const Outcome outcome =
            command({"run", file, "--backend", "reference", "--out", folder / "b", "--resume", checkpoint});

        INFO(checkpoint << ": " << outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.err.find("pelage: ") == 0);
        CHECK(outcome.err.find(checkpoint) != std::string::npos);
    }
}
