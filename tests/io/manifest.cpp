// manifest.json: keys and values.
#include "io/manifest.hpp"
#include "core/error.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

namespace {

Manifest manifest() {
    Manifest manifest;
    manifest.backend = "opencl";
    manifest.device = "a device";
    manifest.driver = "3.1";
    manifest.platform = "a platform";
    manifest.seed = -3;
    manifest.iterations = 5000000000;
    manifest.time = 2.5;
    manifest.options = {{"fast", true, std::nullopt}, {"quiet", true, ""}, {"out", false, "a b"}, {"json", false, {}}};
    manifest.cells = 16900;
    manifest.columns = 130;
    manifest.rows = 130;
    manifest.seconds = 0.1;
    manifest.updates_per_second = 1.5e9;
    manifest.version = "0.1.0";
    manifest.build_options = "-cl-std=CL1.2";
    manifest.files = {"final.exr", "final.png"};
    manifest.started = std::chrono::system_clock::from_time_t(1600000000);
    return manifest;
}

}  // namespace

TEST_CASE("a manifest holds all that is needed to run again") {
    const Scratch scratch;
    auto given = manifest();
    given.more_texts["neighbours"] = "bins";
    given.more_numbers["miss_rate"] = 0.25;
    given.more_numbers["worst"] = std::nan("");

    auto experiment = test::experiment();
    Parameter feed;
    feed.name = "feed";
    feed.value = 0.25;
    experiment.parameters = {feed};
    experiment.inputs = {{"a.png", "12ab"}, {"b.exr", ""}};

    write_manifest(scratch / "manifest.json", given, experiment);
    const auto json = nlohmann::json::parse(test::get(scratch / "manifest.json"));

    CHECK(json == nlohmann::json(
                      {{"backend", "opencl"},
                       {"device", "a device"},
                       {"driver", "3.1"},
                       {"platform", "a platform"},
                       {"precision", "float"},
                       {"seed", -3},
                       {"iterations", 5000000000},
                       {"time", 2.5},
                       {"parameters", {{"feed", 0.25}}},
                       {"options", {{"fast", false}, {"quiet", true}, {"out", "a b"}, {"json", nullptr}}},
                       {"inputs", {{{"file", "a.png"}, {"sha256", "12ab"}}, {{"file", "b.exr"}, {"sha256", nullptr}}}},
                       {"cells", 16900},
                       {"columns", 130},
                       {"rows", 130},
                       {"seconds", 0.1},
                       {"updates_per_second", 1.5e9},
                       {"started", "2020-09-13T12:26:40Z"},
                       {"version", "0.1.0"},
                       {"build_options", "-cl-std=CL1.2"},
                       {"fast", false},
                       {"files", {"final.exr", "final.png"}},
                       {"neighbours", "bins"},
                       {"miss_rate", 0.25},
                       {"worst", nullptr},
                       {"phases", {"development", "maintenance"}},
                       {"experiment", {{"source", "spots.pex"}, {"text", "define chemical U\ndefine chemical V\n"}}}}));
}

TEST_CASE("text that is not UTF-8 is mended, a full disk named") {
    auto experiment = test::experiment();
    experiment.text = "// caf\xe9\n";

    const auto json = nlohmann::json::parse(manifest_text(manifest(), experiment));

    CHECK(json["experiment"]["text"] == "// caf\xef\xbf\xbd\n");
    CHECK_THAT(test::error_of([&] { write_manifest("/dev/full", manifest(), experiment); }), Contains("No space left"));
}
