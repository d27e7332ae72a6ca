// Candidates: their words, their JSON, and the lists of them.
#include "tune/candidate.hpp"

#include "core/error.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace pelage;
using namespace pelage::tune;

namespace {

DeviceInfo processor() {
    DeviceInfo device;
    device.type = "cpu";
    device.vector_width_float = 16;
    device.vector_width_double = 8;
    device.max_work_group = 4096;
    return device;
}

DeviceInfo graphics(std::size_t largest_group) {
    DeviceInfo device;
    device.type = "gpu";
    device.max_work_group = largest_group;
    return device;
}

std::size_t count_kernel(const std::vector<Candidate>& list, Path path) {
    return static_cast<std::size_t>(std::ranges::count(list, path, &Candidate::path));
}

}  // namespace

TEST_CASE("a candidate says in words what it is") {
    CHECK(Candidate{}.text() == "defaults");
    CHECK(Candidate{Path::streamed, 16, {24, 256, 8, 0}}.text() ==
          "streamed, width 16, depth 24, 256 columns, blocks of 8 rows");
    CHECK(Candidate{Path::tiled, 0, {4, 32, 16, 128}}.text() == "tiled, depth 4, tiles of 32 x 16, groups of 128");
    CHECK(Candidate{Path::step, 2, {0, 0, 0, 64}}.text() == "step, width 2, groups of 64");
}

TEST_CASE("a candidate survives the trip through JSON") {
    const DeviceInfo device = GENERATE(processor(), graphics(1024));

    for (const Candidate& candidate : candidates(device, Precision::single_, Effort::exhaustive)) {
        CHECK(candidate_from_json(to_json(candidate)) == candidate);
    }
}

TEST_CASE("what is no candidate is refused") {
    auto json = to_json(Candidate{Path::streamed, 16, {}});

    SECTION("no such kernel") { json["kernel"] = "woven"; }
    SECTION("no such width") { json["width"] = 3; }
    SECTION("a number is missing") { json.erase("depth"); }
    SECTION("a number is a word") { json["rows"] = "many"; }

    CHECK_THROWS_AS(candidate_from_json(json), Error);
}

TEST_CASE("a candidate's choices reach the options, and nothing else changes") {
    OpenclOptions options;
    options.fast = true;

    const OpenclOptions streamed = applied({Path::streamed, 8, {16, 128, 4, 0}}, options);
    const OpenclOptions step = applied({Path::step, 2, {0, 0, 0, 64}}, options);

    CHECK(streamed.path == Path::streamed);
    CHECK(streamed.width == 8);
    CHECK(streamed.cut == LatticeCut{16, 128, 4, 0});
    CHECK(streamed.work_group == 0);
    CHECK(streamed.fast);
    CHECK(step.work_group == 64);
}

TEST_CASE("the defaults come first, the quick list next, and nothing twice") {
    const DeviceInfo device = GENERATE(processor(), graphics(1024));

    const auto quick = candidates(device, Precision::single_, Effort::quick);
    const auto all = candidates(device, Precision::single_, Effort::exhaustive);

    REQUIRE(quick.front() == Candidate{});
    REQUIRE(all.size() > 4 * quick.size());
    CHECK(std::equal(quick.begin(), quick.end(), all.begin()));
    for (const Candidate& candidate : all) CHECK(std::ranges::count(all, candidate) == 1);
}

TEST_CASE("each kind of device gets its own kernels") {
    const auto on_processor = candidates(processor(), Precision::single_, Effort::exhaustive);
    const auto on_graphics = candidates(graphics(1024), Precision::single_, Effort::exhaustive);

    CHECK(count_kernel(on_processor, Path::streamed) == 96);
    CHECK(count_kernel(on_processor, Path::shared) == 2);
    CHECK(count_kernel(on_processor, Path::tiled) == 0);
    CHECK(count_kernel(on_graphics, Path::tiled) == 108);
    CHECK(count_kernel(on_graphics, Path::shared) == 0);
}

TEST_CASE("widths follow the lanes of the precision, groups the device's limit") {
    const auto doubles = candidates(processor(), Precision::double_, Effort::exhaustive);
    const auto narrow = candidates(graphics(128), Precision::single_, Effort::exhaustive);

    for (const Candidate& candidate : doubles) CHECK(candidate.width <= 8);
    for (const Candidate& candidate : narrow) CHECK(candidate.cut.group <= 128);
    CHECK(count_kernel(narrow, Path::tiled) == 36);
}
