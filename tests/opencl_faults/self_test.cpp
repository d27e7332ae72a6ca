// Calls that fail while a device is tested before a run.
#include "codes.hpp"
#include "every_call.hpp"
#include "support/form.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

using test::Ending;
using test::Faults;
using test::Stage;

namespace {

// A run does not repeat a test that its device has passed before.
void forget_tests(const std::filesystem::path& cache) {
    for (const std::string& name : test::names_in(cache)) {
        if (name.ends_with(".self-test")) std::filesystem::remove(cache / name);
    }
}

}  // namespace

TEST_CASE("a self-test that an OpenCL call breaks off ends the run before anything is written, and is not passed") {
    Stage stage(GENERATE(Stage::Play::lattice, Stage::Play::cells));
    const test::Folder cache;
    const test::Variable variable("PELAGE_CACHE", cache.path().c_str());
    Faults& layer = Faults::layer();
    test::calls_of_a_good_run(stage);
    const std::size_t calls_of_run = layer.calls().size();
    stage.options().no_self_test = false;
    layer.reset();
    REQUIRE(stage.run().finished);
    const std::size_t calls_of_test = layer.calls().size() - calls_of_run;
    REQUIRE(calls_of_test > 100);
    const std::size_t parts = test::long_form() ? 24 : 3;
    constexpr std::size_t opening = 60;  // calls that choose a device, for the run itself

    for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t nth = opening + (calls_of_test - opening) * part / parts;
        forget_tests(cache.path());
        layer.reset();
        layer.fail(nth, CL_OUT_OF_RESOURCES);
        const Ending ending = stage.run();

        INFO(fmt::format("call {} of {}: {}", nth, calls_of_test, ending.error));
        CHECK(layer.struck() == 1);
        if (ending.finished) {  // a release
            test::check_nothing_broken(stage, ending);
        } else {
            CHECK(test::tells(ending.error, layer.calls()[nth].name, CL_OUT_OF_RESOURCES));
            CHECK_FALSE(std::filesystem::exists(stage.results()));
            for (const std::string& name : test::names_in(cache.path())) CHECK_FALSE(name.ends_with(".self-test"));
        }
        CHECK(layer.unbalanced().empty());
    }
    layer.reset();
}
