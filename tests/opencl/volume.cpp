// Volumes end in the reference's bits on every path, however a run is cut.
#include "core/growable.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "lattice_run.hpp"
#include "opencl/backend.hpp"
#include "opencl/volume/step.hpp"
#include "reference/backend.hpp"
#include "support/variable.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace pelage;

namespace {

const std::string spotted =
    "define chemical U\ndefine chemical V\ndefine time_step 0.02\nuse chemical U conc 4 dev 0.5 diff 2\n"
    "use chemical V conc 4 dev 0.5 diff 0.5\ncreate volume 13 31 9 wrap\n"
    "rule always react U V turing alpha 16 beta (12 + 0.1 * sin(Z))\nrule probability 0.1 change V conc 0.1 dev 0.1\n";

OpenclOptions waves(std::size_t depth, std::size_t rows) {
    OpenclOptions options;
    options.path = Path::streamed;
    options.cut.depth = depth;
    options.cut.rows = rows;
    return options;
}

DeviceInfo two_processors() {
    DeviceInfo device;
    device.type = "cpu";
    device.compute_units = 2;
    device.processors = 2;
    return device;
}

}  // namespace

TEST_CASE("volume: single steps and waves of any depth have the reference's bits, however a run is cut") {
    const Experiment experiment = parse_experiment(spotted, "spotted.pex", ".");
    const Snapshot initial = initial_state(experiment);
    const auto expected = reference_backend(Precision::single_)->make_tissue(experiment, initial);
    expected->advance(23);
    OpenclOptions single;
    single.path = Path::step;
    for (const OpenclOptions& options :
         {single, waves(2, 5), waves(3, 7), waves(7, 15), waves(4, 31), OpenclOptions{}}) {
        const auto found = opencl_backend(options)->make_tissue(experiment, initial);
        found->advance(5);
        found->advance(18);
        test::require_equal(expected->read(), found->read());
    }
}

TEST_CASE("volume: of several cuts the fastest is found, and then kept") {
    const DeviceInfo processor = two_processors();
    Choice choice;
    choice.path = Path::streamed;
    choice.cut.depth = 8;
    choice.cut.rows = 0;
    VolumeCuts cuts(processor, choice, {256, 256, 256});
    std::vector<std::pair<std::size_t, std::size_t>> tried;
    while (cuts.searching()) {
        const FusedShape& cut = cuts.now().cut;
        tried.emplace_back(cut.depth, cut.rows);
        REQUIRE(tried.size() < 100);
        const bool first = tried.size() == 1;  // it waits for the compiler
        cuts.took(first ? 9.0 : cut.rows == 64 ? 0.5 : 1.0);
    }
    const std::vector<std::pair<std::size_t, std::size_t>> once{{8, 32}, {4, 32}, {8, 64}, {8, 128}};
    CHECK(std::equal(once.begin(), once.end(), tried.begin()));
    CHECK(tried.size() == 2 * once.size());
    CHECK(cuts.now().cut.depth == 8);
    CHECK(cuts.now().cut.rows == 64);

    CHECK_FALSE(VolumeCuts(processor, choice, {8, 8, 8}).now().cut.rows > 4);  // each processor has some
    CHECK(VolumeCuts(processor, choice, {64, 64, 7}).now().cut.depth == 5);
    choice.cut.rows = 10;
    CHECK_FALSE(VolumeCuts(processor, choice, {256, 256, 256}).searching());  // asked for
    choice.path = Path::step;
    choice.cut.rows = 0;
    CHECK_FALSE(VolumeCuts(processor, choice, {256, 256, 256}).searching());
}

TEST_CASE("volume: a wave has no more steps than its layers and rows allow") {
    const DeviceInfo processor = two_processors();
    Choice choice;
    choice.path = Path::streamed;
    choice.cut.depth = 4;
    choice.cut.rows = 10;
    CHECK(volume_shape(processor, choice, {64, 64, 64}, 100).steps == 4);
    CHECK(volume_shape(processor, choice, {64, 64, 64}, 100).strips == 6);
    CHECK(volume_shape(processor, choice, {64, 64, 64}, 3).steps == 3);
    CHECK(volume_shape(processor, choice, {64, 64, 5}, 100).steps == 1);
    CHECK(volume_shape(processor, choice, {64, 8, 64}, 100).strips == 1);
    choice.cut.rows = 1;
    CHECK(volume_shape(processor, choice, {64, 64, 64}, 100).strips == 7);  // of 9 rows at least
    choice.path = Path::step;
    CHECK(volume_shape(processor, choice, {64, 64, 64}, 100).steps == 1);
}

TEST_CASE("volume: neither grows nor takes another space's state") {
    const Experiment experiment = parse_experiment(spotted, "spotted.pex", ".");
    const auto tissue = opencl_backend({})->make_tissue(experiment, initial_state(experiment));
    CHECK(tissue->layers() == 9);
    CHECK_THROWS_WITH(growable(*tissue), Catch::Matchers::Contains("is a volume"));
    Snapshot flat = tissue->read();
    flat.rows *= flat.layers;
    flat.layers = 0;
    CHECK_THROWS_WITH(tissue->write(flat), Catch::Matchers::Contains("cannot take each other's state"));
}

TEST_CASE("volume: a share of the cases of `pelage verify` in waves") {
    test::check_cases("volume/", waves(3, 7), {1, 5});
}
