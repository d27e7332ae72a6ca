// The published experiments: every one is read, and says what its authors' program read in it.
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace pelage;
namespace fs = std::filesystem;

namespace {

const std::string misspelt = "activation-18-automata-3.pex";  // says `use` for `define`

std::vector<fs::path> published() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(test::shared("pex"))) {
        if (entry.path().extension() == ".pex") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void check_chemicals(const Experiment& e, const nlohmann::json& facts) {
    REQUIRE(e.chemicals.size() == facts.size());
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const auto& limit = facts[i].at("limit");
        CHECK(e.chemicals[i].name == facts[i].at("name").get<std::string>());
        CHECK(e.chemicals[i].anisotropic == facts[i].at("anisotropic").get<bool>());
        if (limit.is_null())
            CHECK(std::isinf(e.chemicals[i].bounds.limit));
        else
            CHECK(e.chemicals[i].bounds.limit == Approx(limit.get<double>()).epsilon(1e-6));
    }
}

}  // namespace

TEST_CASE("every published experiment but the misspelt one is read") {
    if (test::shared_missing("pex")) return;
    std::size_t read = 0;

    for (const fs::path& file : published()) {
        if (file.filename() == misspelt) continue;
        INFO(file);
        CHECK_NOTHROW(parse_experiment_file(file));
        ++read;
    }

    CHECK(read >= 83);
}

TEST_CASE("the misspelt published experiment gets a clear message") {
    if (test::shared_missing("pex")) return;
    const std::string file = test::shared("pex/basic-activation/" + misspelt).string();

    CHECK_THROWS_WITH(
        parse_experiment_file(file),
        file + ":3:14: unknown chemical 'P': 'use' names a chemical that is not defined; defined here: none");
}

TEST_CASE("published experiments mean what their authors' program made of them") {
    if (test::shared_missing("golden/pattern_explorer") || test::shared_missing("pex")) return;
    std::size_t compared = 0;

    for (const auto& entry : fs::directory_iterator(test::shared("golden/pattern_explorer"))) {
        std::ifstream file(entry.path() / "info.json");
        if (!file) continue;
        const auto facts = nlohmann::json::parse(file);
        const fs::path pex = test::shared("pex") / facts.at("pex").get<std::string>();
        if (facts.at("rc") != 0 || !fs::exists(pex)) continue;
        const Experiment e = parse_experiment_file(pex);
        INFO(pex);
        check_chemicals(e, facts.at("chemicals"));
        CHECK(e.stop_at == facts.at("stop").get<std::uint64_t>());
        CHECK(e.phases.at(0).time_step == Approx(facts.at("dt").get<double>()).epsilon(1e-6));
        CHECK(e.domain.packed == facts.at("packed").get<bool>());
        CHECK(e.division_limit == facts.at("division_limit").get<std::size_t>());
        CHECK(count_cells(e) == facts.at("cells0").get<std::size_t>());
        ++compared;
    }

    CHECK(compared >= 70);
}

TEST_CASE("round facts of single published experiments") {
    struct Facts {
        const char* file;
        std::size_t chemicals, mappings, statements, rules;
        std::uint64_t stop;
    };
    const Facts all[] = {
        {"automata-distance/distance-02-chessboard.pex", 4, 0, 6, 10, 21},
        {"automata-wireworld/wireworld-01-base.pex", 3, 0, 24, 13, 10000},
        {"basic-modulation/modulation-06-spot-scaling.pex", 4, 1, 6, 4, 10000},
        {"basic-shape/shape-01-wrap-around.pex", 2, 0, 4, 1, 5000},
        {"growth-uniform/uniform-03-reinforcement.pex", 3, 1, 5, 6, 10000},
        {"paper/23-saturated-poison-dart-frog.pex", 2, 0, 10, 1, 5000},
        {"paper/25-saturated-leopard.pex", 2, 0, 36, 2, 14000},
    };
    if (test::shared_missing("pex")) return;
    for (const Facts& facts : all) {
        const Experiment e = parse_experiment_file(test::shared("pex") / facts.file);

        INFO(facts.file);
        CHECK(e.chemicals.size() == facts.chemicals);
        CHECK(e.mappings.size() == facts.mappings);
        CHECK(e.prepattern.size() == facts.statements);
        CHECK(e.rules.size() == facts.rules);
        CHECK(e.stop_at == facts.stop);
    }
}

TEST_CASE("the published leopard in detail") {
    if (test::shared_missing("pex")) return;

    const Experiment e = parse_experiment_file(test::shared("pex/paper/25-saturated-leopard.pex"));

    CHECK(e.texture == std::array<std::size_t, 2>{512, 512});
    CHECK(e.zoom == 1.503);
    CHECK(e.outputs.at(0).colormap.name == "gradient");
    CHECK(e.outputs[0].colormap.stops.size() == 4);
    CHECK(e.rules.at(1).from == 4000);
    CHECK(std::get<Divide>(e.rules[1].action).deviation == 180.0);
    CHECK(std::get<CreateGrid>(e.prepattern.at(3)).arrangement == Arrangement::hex_grid);
}

TEST_CASE("experiments of ours are read") {
    std::size_t read = 0;

    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PELAGE_SOURCE) / "experiments")) {
        const fs::path folder = entry.path().parent_path().filename();
        // One has parts of others, which include them, the other an experiment whose network everyone brings along.
        const bool part = folder == "gray-scott" || folder == "neural";
        if (entry.path().extension() != ".pex" || part) continue;
        INFO(entry.path());
        CHECK_NOTHROW(parse_experiment_file(entry.path()));
        ++read;
    }

    CHECK(read > 0);
}
