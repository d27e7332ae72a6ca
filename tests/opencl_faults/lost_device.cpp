// Devices that disappear, and devices whose memory gives out, in the middle of a run.
#include "every_call.hpp"

#include "io/checkpoint.hpp"
#include "support/form.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <new>
#include <regex>
#include <string>

using Catch::Contains;
using test::Ending;
using test::Faults;
using test::Stage;

namespace {

// N of "the state at iteration N is safe", 0 where that is not said.
std::uint64_t safe_iteration(const std::string& error) {
    std::smatch found;
    const std::regex words("; the state at iteration ([0-9]+) is safe, go on with:\n  pelage run .* --resume .*");
    return std::regex_search(error, found, words) ? std::stoull(found[1]) : 0;
}

// Runs with less and less memory. The first of the pair: runs that ended well though a buffer was refused; the
// second: runs that did not.
std::pair<int, int> run_with_little_memory(Stage& stage, std::size_t all) {
    Faults& layer = Faults::layer();
    int recovered = 0;
    int refused = 0;
    for (std::size_t percent = 100; percent >= 40; percent -= test::long_form() ? 3 : 10) {
        layer.reset();
        stage.machine.memory = all / 100 * percent;
        INFO(fmt::format("{} of {} bytes", stage.machine.memory, all));
        const Ending ending = stage.run();

        INFO(ending.error);
        if (ending.finished && layer.refused() > 0) ++recovered;
        if (!ending.finished) ++refused;
        if (!ending.finished) {
            CHECK_THAT(ending.error, Contains("no buffer of ") && Contains(" bytes for the ") &&
                                         Contains("CL_MEM_OBJECT_ALLOCATION_FAILURE") && Contains("device '"));
        }
        test::check_nothing_broken(stage, ending);
    }
    layer.reset();
    return {recovered, refused};
}

// How often `new` was said to have failed, and the latest call of the driver when it first was.
int wanting = 0;
std::string last_call;

void note_want() {
    if (wanting++ == 0) last_call = Faults::layer().calls().back().name;
}

}  // namespace

TEST_CASE("a compiler without memory is told to the process before any other call of the driver") {
    Faults& layer = Faults::layer();
    layer.reset();
    Stage stage(Stage::Play::lattice);
    layer.fail("clBuildProgram", 0, CL_OUT_OF_HOST_MEMORY);
    wanting = 0;
    const std::new_handler before = std::set_new_handler(note_want);

    const Ending ending = stage.run();

    std::set_new_handler(before);
    layer.reset();
    CHECK_FALSE(ending.finished);
    CHECK_THAT(ending.error, Contains("CL_OUT_OF_HOST_MEMORY"));
    CHECK(wanting == 1);
    CHECK(last_call == "clBuildProgram");
}

TEST_CASE("a device that disappears ends a run with one sentence, and leaves whole files") {
    Faults& layer = Faults::layer();
    for (const Stage::Play play : test::all_plays) {
        Stage stage(play);
        const std::size_t calls = test::calls_of_a_good_run(stage).size();
        const std::size_t parts = test::long_form() ? 10 : 2;
        for (std::size_t part = 0; part < parts; ++part) {
            INFO(fmt::format("at call {} of {}", calls * part / parts, calls));
            layer.reset();
            layer.lose_device(calls * part / parts);
            const Ending ending = stage.run();

            CHECK_FALSE(ending.finished);
            CHECK_THAT(ending.error, Contains("CL_DEVICE_NOT_AVAILABLE"));
            test::check_nothing_broken(stage, ending);
        }
    }
    layer.reset();
}

TEST_CASE("the last checkpoint of a run whose device disappeared is named, and goes on to the same results") {
    const auto play = GENERATE(Stage::Play::lattice, Stage::Play::cells);
    Faults& layer = Faults::layer();
    Stage stage(play);
    const std::size_t calls = test::calls_of_a_good_run(stage).size();
    layer.reset();
    layer.lose_device(calls * 9 / 10);

    const Ending lost = stage.run();
    const auto saved = pelage::read_checkpoint(stage.results() / "checkpoint.pelage");
    stage.resume();
    layer.reset();
    const Ending resumed = stage.run();

    INFO(lost.error);
    CHECK(safe_iteration(lost.error) == saved.snapshot.iteration);
    CHECK(saved.snapshot.iteration > 0);
    INFO(resumed.error);
    CHECK(resumed.finished);
    CHECK(stage.damage().empty());
    CHECK(test::read_all(stage.results() / "final.U.npy") == stage.good().at("final.U.npy"));
    layer.reset();
}

TEST_CASE("a long run whose device disappears saves the latest state that was read, checkpoints asked for or not") {
    Faults& layer = Faults::layer();
    Stage stage(Stage::Play::lattice_on_gpu);
    test::calls_of_a_good_run(stage);  // its programs are compiled
    layer.reset();
    stage.options().iterations = 1'000'000'000;
    stage.options().checkpoint_every = 0;
    stage.options().snap_every = 0;
    layer.lose_device_after(std::chrono::milliseconds(4500));

    const Ending ending = stage.run();

    INFO(ending.error);
    CHECK_THAT(ending.error, Contains("CL_DEVICE_NOT_AVAILABLE"));
    REQUIRE(test::names_in(stage.results()) == std::vector<std::string>{"checkpoint.pelage"});
    const auto saved = pelage::read_checkpoint(stage.results() / "checkpoint.pelage");
    CHECK(saved.snapshot.iteration > 100);
    CHECK(safe_iteration(ending.error) == saved.snapshot.iteration);
    CHECK(saved.snapshot.rows == 4);
    layer.reset();
}

TEST_CASE("memory that gives out while the tissue grows changes no result: less is asked for, or the run says so") {
    const auto [play, can_do_with_less] =
        GENERATE(std::pair(Stage::Play::lattice, false), std::pair(Stage::Play::lattice_on_gpu, true),
                 std::pair(Stage::Play::cells, false));
    Stage stage(play);
    test::calls_of_a_good_run(stage);
    const std::size_t all = Faults::layer().most_bytes();
    REQUIRE(all > 1000);

    const auto [recovered, refused] = run_with_little_memory(stage, all);

    if (can_do_with_less) CHECK(recovered > 0);
    CHECK(refused > 0);
}
