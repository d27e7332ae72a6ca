// `pelage learn`, as a user calls it.
#include "io/network.hpp"
#include "training.hpp"

#include <catch2/catch.hpp>

#include <csignal>
#include <filesystem>

using namespace pelage;
using test::command;
using test::training_words;
using test::write_spots;

TEST_CASE("a training ends in a model, a curve and a picture, resumed in the same bits") {
    const std::string backend = GENERATE("reference", "opencl");
    const test::Folder folder;
    write_spots(folder / "spots.png");
    const auto whole = command(training_words(folder, "a.npz", {"--steps", "12", "--backend", backend}));
    INFO(whole.err);
    REQUIRE(whole.exit_code == 0);
    CHECK(whole.out == (folder / "a.npz").string() + "\n");
    CHECK_THAT(whole.err, Catch::Contains("seed states have a loss of"));
    for (const char* name : {"a.npz", "a.loss.csv", "a.preview.png", "a.checkpoint"})
        CHECK(std::filesystem::exists(folder / name));
    const Network network = read_network(folder / "a.npz").network;
    CHECK(network.chemicals == 4);
    CHECK(network.hidden == 8);

    REQUIRE(command(training_words(folder, "b.npz", {"--steps", "5", "--backend", backend})).exit_code == 0);
    CHECK_THAT(command(training_words(folder, "b.npz", {"--steps", "12", "--backend", backend})).err,
               Catch::Contains("go on from it with --resume"));
    CHECK_THAT(command(training_words(folder, "b.npz", {"--steps", "5", "--backend", backend, "--resume"})).err,
               Catch::Contains("has 5 steps already"));
    REQUIRE(command(training_words(folder, "b.npz", {"--steps", "12", "--backend", backend, "--resume"})).exit_code ==
            0);
    CHECK(test::read_all(folder / "a.npz") == test::read_all(folder / "b.npz"));
    CHECK(test::read_all(folder / "a.loss.csv") == test::read_all(folder / "b.loss.csv"));
    CHECK(test::read_all(folder / "a.checkpoint") == test::read_all(folder / "b.checkpoint"));
}

TEST_CASE("Ctrl-C saves a training") {
    const test::Folder folder;
    write_spots(folder / "spots.png");
    std::vector<std::string> words = training_words(folder, "a.npz", {"--steps", "100000", "--preview-every", "1"});
    words.insert(words.begin(), test::program);
    test::Child child(words);
    REQUIRE(test::wait_for(folder / "a.npz", child));
    child.signal(SIGINT);
    const auto stopped = child.wait();
    CHECK(stopped.exit_code == 130);
    CHECK_THAT(stopped.err, Catch::Contains("--resume goes on from"));
    CHECK(std::filesystem::exists(folder / "a.checkpoint"));
}

TEST_CASE("what a training cannot be is told in a sentence, and leaves nothing") {
    const test::Folder folder;
    write_spots(folder / "spots.png");
    const auto refused = [&](const std::vector<std::string>& more) {
        const auto outcome = command(training_words(folder, "a.npz", more));
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.err.starts_with("pelage: "));
        return outcome.err;
    };
    CHECK_THAT(refused({"--size", "32", "--chemicals", "6"}), Catch::Contains("given more than once"));
    CHECK_THAT(refused({"--rate", "-1"}), Catch::Contains("--rate: '-1' is not a number from 1e-09 to 1e+30"));
    CHECK_THAT(refused({"--rate", "fast"}), Catch::Contains("--rate: 'fast' is not a number"));
    CHECK_THAT(refused({"--drop-at", "10,x"}), Catch::Contains("'x' is not a whole number from 1 to"));
    CHECK_THAT(refused({"--resume"}), Catch::Contains("a.checkpoint"));
    CHECK_THAT(refused({"--backend", "opencl", "--device", "no such"}), Catch::Contains("no such"));
    CHECK(test::names_in(folder.path()) == std::vector<std::string>{"spots.png"});

    const std::string picture = (folder / "spots.png").string();
    CHECK_THAT(command({"learn", picture, "--size", "48", "--chemicals", "5"}).err,
               Catch::Contains("--chemicals: '5' is not a multiple of 4 from 4 to 64"));
    CHECK_THAT(command({"learn", picture, "--size", "512", "--pool", "1000000"}).err, Catch::Contains("takes up to"));
    const std::string preview = folder / "a.preview.png";
    write_spots(preview);
    CHECK_THAT(command({"learn", preview, "--out", folder / "a.npz"}).err,
               Catch::Contains(preview + " is the picture that is learned"));
    CHECK_THAT(command({"learn", picture, "--out", "model.txt"}).err, Catch::Contains("must end in .npz"));
    std::filesystem::create_directory(folder / "folder.npz");
    CHECK_THAT(command({"learn", picture, "--out", folder / "folder.npz"}).err, Catch::Contains("is a folder"));
    CHECK_THAT(command({"learn", picture, "--out", "/proc/none/a.npz"}).err, Catch::Contains("/proc/none"));
    CHECK_THAT(command({"learn", (folder / "none.png").string()}).err, Catch::Contains("none.png"));
}
