// What `pelage learn` does when it is disturbed: by another training, by signals, by numbers, by a disk.
#include "core/error.hpp"
#include "io/locked.hpp"
#include "training.hpp"

#include <unistd.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

using Catch::Contains;
using test::Child;
using test::command;
using test::Folder;
using test::training_words;

namespace fs = std::filesystem;

namespace {

std::vector<std::string> program_and(std::vector<std::string> words) {
    words.insert(words.begin(), test::program);
    return words;
}

// A training that goes on until something ends it, with a checkpoint at every step, once its first results are there.
struct Endless {
    explicit Endless(const Folder& folder)
        : child(program_and(training_words(
              folder, "a.npz", {"--steps", "1000000", "--preview-every", "1", "--checkpoint-every", "1", "--quiet"}))) {
        REQUIRE(test::wait_for(folder / "a.loss.csv", child));
    }
    Child child;
};

// A training that is sent a signal as soon as it has said `words`, before its first step.
test::Outcome signalled_at(const Folder& folder, const std::string& words, int signal, std::vector<std::string> more) {
    const fs::path said = folder / "said";
    std::string line = "exec '" + test::program + "' learn '" + (folder / "spots.png").string() + "' --out '" +
                       (folder / "a.npz").string() + "'";
    for (const std::string& word : more) line += " " + word;
    test::Surroundings fresh;
    fresh.environment["PELAGE_CACHE"] = folder / "cache";  // there is something to compile
    Child child({"sh", "-c", line + " 2>'" + said.string() + "'"}, fresh);
    REQUIRE(test::wait_for(said, child));
    const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < latest && test::read_all(said).find(words) == std::string::npos)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    child.signal(signal);
    test::Outcome outcome = child.wait();
    outcome.err = test::read_all(said);
    return outcome;
}

}  // namespace

TEST_CASE("two trainings to one file are kept apart, and one that was killed stands in nobody's way") {
    const Folder folder;
    test::write_spots(folder / "spots.png");
    Endless first(folder);
    const test::Outcome second = command(training_words(folder, "a.npz", {"--steps", "2", "--resume"}));
    CHECK(second.exit_code == 2);
    CHECK(second.err == "pelage: another process (" + std::to_string(first.child.id()) + ") trains to '" +
                            (folder / "a.npz").string() + "' at this moment; name another file\n");
    CHECK(command(training_words(folder, "b.npz", {"--steps", "2"})).exit_code == 0);
    first.child.signal(SIGKILL);
    CHECK(first.child.wait().exit_code == 128 + SIGKILL);
    fs::remove(folder / "a.checkpoint");
    const test::Outcome over_a_model = command(training_words(folder, "a.npz", {"--steps", "2"}));
    CHECK(over_a_model.exit_code == 2);
    CHECK(over_a_model.err.find("a.npz' is there already: name another file with --out, or remove it") !=
          std::string::npos);
    fs::remove(folder / "a.npz");
    const test::Outcome third = command(training_words(folder, "a.npz", {"--steps", "2"}));
    INFO(third.err);
    CHECK(third.exit_code == 0);
    CHECK(std::ranges::none_of(test::names_in(folder.path()), [](const std::string& name) { return name[0] == '.'; }));
}

TEST_CASE("a file's lock is held by one, freed with it, and its file goes with it") {
    const Folder folder;
    const fs::path file = folder / ".lock";
    const auto taken = [&] {
        try {
            const pelage::FileLock lock(file, "writes");
        } catch (const pelage::Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    {
        const pelage::FileLock lock(file, "writes");
        CHECK_THAT(taken(), Contains("another process (" + std::to_string(getpid()) + ") writes at this moment"));
        CHECK(fs::exists(file));
    }
    CHECK_FALSE(fs::exists(file));
    CHECK(taken().empty());
    folder.write(".lock", "what a killed one left");
    CHECK(taken().empty());
    const pelage::FileLock lock(folder / "other", "writes");
    folder.write("other", "");  // before it wrote its number
    try {
        const pelage::FileLock again(folder / "other", "writes");
        FAIL("taken twice");
    } catch (const pelage::Error& error) {
        CHECK_THAT(error.what(), Contains("another process writes at this moment"));
    }
    CHECK_THROWS_WITH(pelage::FileLock(folder / "none/x", "writes"), Contains("none/x' cannot be made: No such"));
}

TEST_CASE("a signal before the first step ends a training with a sentence") {
    const Folder folder;
    test::write_spots(folder / "spots.png");
    const auto [signal, words] = GENERATE(table<int, std::string>(
        {{SIGINT, "preparing the picture"}, {SIGTERM, "preparing the picture"}, {SIGTERM, "building kernels"}}));
    std::vector<std::string> more{"--chemicals", "64", "--hidden", "256", "--pool", "4"};
    if (words != "building kernels") more.insert(more.end(), {"--size", "128", "--rotations", "64", "--wrap"});
    const test::Outcome outcome = signalled_at(folder, words, signal, more);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 128 + signal);
    CHECK(outcome.err.ends_with("...\npelage: stopped before the first step; nothing was trained yet\n"));
    CHECK(outcome.out.empty());
    for (const char* name : {"a.npz", ".a.pelage-learn"}) CHECK_FALSE(fs::exists(folder / name));
}

TEST_CASE("numbers that run away for good fail the training, which keeps what was sound") {
    const Folder folder;
    test::write_spots(folder / "spots.png");
    const std::string backend = GENERATE("reference", "opencl");
    const test::Outcome outcome =
        command(training_words(folder, "a.npz", {"--steps", "100", "--rate", "1e30", "--quiet", "--backend", backend}));
    INFO(outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Catch::StartsWith("pelage: numbers run away at step ") &&
                                Contains("the last sound weights are in '" + (folder / "a.npz").string()) &&
                                !Contains("pelage-plot"));
    CHECK(fs::exists(folder / "a.npz"));
    CHECK(fs::exists(folder / "a.checkpoint"));
}

TEST_CASE("where no step's numbers hold, nothing is kept and no picture of losses is drawn") {
    const Folder folder;
    test::write_spots(folder / "spots.png");
    fs::copy(fs::path(PELAGE_SOURCE) / "kernels", folder / "kernels", fs::copy_options::recursive);
    std::string source = test::read_all(folder / "kernels/learn/loss.cl");
    const std::string text = "*to = states[sample * PELAGE_SAMPLE + pixel];";
    REQUIRE(source.find(text) != std::string::npos);
    folder.write("kernels/learn/loss.cl",
                 source.replace(source.find(text), text.size(), "*to = (scalar)0.0f / (scalar)0.0f;"));
    test::Surroundings broken;
    broken.environment["PELAGE_KERNELS"] = folder / "kernels";
    const auto [steps, why] = GENERATE(table<std::string, std::string>(
        {{"1", "numbers ran away in every step, nothing was learned"}, {"40", "numbers run away at step 17, even"}}));
    const test::Outcome outcome =
        command(training_words(folder, "a.npz", {"--backend", "opencl", "--quiet", "--steps", steps}), broken);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.err, Contains("pelage: " + why) && Contains("nothing was learned") && !Contains("pelage-plot"));
    for (const char* name : {"a.npz", "a.checkpoint", "a.loss.csv", "a.loss.png"})
        CHECK_FALSE(fs::exists(folder / name));
}

TEST_CASE("a training whose results cannot be written is saved, and goes on when they can") {
    const Folder folder;
    test::write_spots(folder / "spots.png");
    Endless training(folder);
    fs::rename(folder / "a.loss.csv", folder / "away");
    fs::create_directories(folder / "a.loss.csv" / "in the way");
    const test::Outcome outcome = training.child.wait();
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, Catch::StartsWith("pelage: ") && Contains("a.loss.csv") && Contains(" is safe in '") &&
                                Contains("a.checkpoint', and the same command with --resume goes on from it"));
    fs::remove_all(folder / "a.loss.csv");
    const std::string step = outcome.err.substr(outcome.err.find("; step ") + 7);
    const std::string more = std::to_string(std::stoull(step) + 2);
    const test::Outcome resumed = command(training_words(folder, "a.npz", {"--steps", more, "--resume"}));
    INFO(resumed.err);
    CHECK(resumed.exit_code == 0);
}

TEST_CASE("a training whose disk is full or whose folder goes says which steps are safe") {
    const Folder folder;
    test::write_spots(folder / "spots.png");
    test::Surroundings full;
    full.largest_file = 40'000;  // less than a checkpoint has after a few steps
    const test::Outcome lost =
        command(training_words(folder, "a.npz", {"--steps", "100", "--checkpoint-every", "1", "--quiet"}), full);
    INFO(lost.err);
    CHECK(lost.exit_code == 2);
    CHECK_THAT(lost.err,
               Contains("a.checkpoint") && Contains("could not be saved either") && Contains(" is safe in '"));

    fs::create_directory(folder / "out");
    test::write_spots(folder / "out/spots.png");
    std::vector<std::string> words =
        training_words(folder, "out/b.npz", {"--steps", "1000000", "--preview-every", "1", "--quiet"});
    Child child(program_and(words));
    REQUIRE(test::wait_for(folder / "out/b.loss.csv", child));
    fs::rename(folder / "out", folder / "gone");
    const test::Outcome outcome = child.wait();
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err,
               Catch::StartsWith("pelage: ") && Contains("could not be saved either") && !Contains("is safe in"));
}
