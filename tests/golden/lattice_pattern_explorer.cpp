// Pattern Explorer's own results on square grids: the float reference gives the same bits, from first to last
// iteration.
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "language/parse.hpp"
#include "lattice_support.hpp"
#include "reference/backend.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace {

using namespace pelage;
namespace fs = std::filesystem;

struct Case {
    std::string name;
    nlohmann::json info;

    bool square_grid() const { return info.at("nns").get<std::string>().rfind("square grid", 0) == 0; }
    NpyArray array(const std::string& file) const { return test::golden("pattern_explorer/" + name + "/" + file); }
    Experiment experiment() const {
        return parse_experiment_file(test::shared("pex/" + info.at("pex").get<std::string>()));
    }
};

std::vector<Case> square_grids(const std::string& prefix) {
    std::vector<Case> cases;
    for (const auto& folder : fs::directory_iterator(test::shared("golden/pattern_explorer"))) {
        const std::string name = folder.path().filename().string();
        if (!folder.is_directory() || name.rfind(prefix, 0) != 0) continue;
        std::ifstream file(folder.path() / "info.json");
        Case one{name, nlohmann::json::parse(file)};
        if (one.square_grid()) cases.push_back(std::move(one));
    }
    std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.name < b.name; });
    return cases;
}

// Golden arrays hold the chemicals of a cell side by side.
std::vector<double> side_by_side(const std::vector<std::vector<double>>& chemicals) {
    std::vector<double> values;
    for (std::size_t cell = 0; cell < chemicals.front().size(); ++cell) {
        for (const auto& chemical : chemicals) values.push_back(chemical[cell]);
    }
    return values;
}

template <class V>
std::vector<double> numbers_of(const std::vector<V>& values) {
    return {values.begin(), values.end()};
}

void check_same(const Case& golden, const std::string& array, const std::vector<double>& found) {
    INFO(golden.name << " " << array);
    const test::Difference difference = test::difference(found, golden.array(array).values);
    CHECK(difference.unequal == 0);
    CHECK(difference.largest == 0.0);
}

void check_initial(const Case& golden, const Snapshot& state) {
    check_same(golden, "conc_0", side_by_side(state.conc));
    check_same(golden, "diff_0", side_by_side(state.diff));
    check_same(golden, "x_0", state.x);
    check_same(golden, "y_0", state.y);
    check_same(golden, "px_0", state.polarity_x);
    check_same(golden, "py_0", state.polarity_y);
    check_same(golden, "birth_0", numbers_of(state.birth));
    check_same(golden, "fixed_0", numbers_of(state.fixed));
    check_same(golden, "neighbors_0", numbers_of(state.neighbours));
}

void check_case(const Case& golden) {
    const Experiment experiment = golden.experiment();
    REQUIRE(std::holds_alternative<Lattice>(space_of(experiment)));
    Snapshot state = initial_state(experiment);
    if (golden.info.at("seed0")) {  // drawn with a seed from the clock
        const std::vector<double> values = golden.array("conc_0").values;
        REQUIRE(state.conc.size() == 1);
        state.conc.front() = values;
    }
    check_initial(golden, state);
    if (golden.info.at("random_rules")) return;

    const auto tissue = reference_backend(Precision::single_)->make_tissue(experiment, state);
    for (const std::string at : golden.info.at("states")) {
        if (at == "0") continue;
        const auto iteration = at == "final" ? golden.info.at("iterations").get<std::uint64_t>() : std::stoull(at);
        tissue->advance(iteration - tissue->iteration());
        const Snapshot now = tissue->read();
        check_same(golden, "conc_" + at, side_by_side(now.conc));
        check_same(golden, "neighbors_" + at, numbers_of(now.neighbours));
    }
}

void check_all(const std::string& prefix, std::size_t wanted) {
    if (test::shared_missing("golden/pattern_explorer")) return;
    const std::vector<Case> cases = square_grids(prefix);
    REQUIRE(cases.size() >= wanted);
    for (const Case& golden : cases) check_case(golden);
}

}  // namespace

TEST_CASE("Pattern Explorer's automata, bit for bit") { check_all("automata-", 9); }
TEST_CASE("Pattern Explorer's activation, bit for bit") { check_all("basic-activation", 15); }
TEST_CASE("Pattern Explorer's anisotropic diffusion, bit for bit") { check_all("basic-anisotropy", 2); }
TEST_CASE("Pattern Explorer's diffusion, bit for bit") { check_all("basic-diffusion", 4); }
TEST_CASE("Pattern Explorer's modulation, bit for bit") { check_all("basic-modulation", 3); }
TEST_CASE("Pattern Explorer's polarity, bit for bit") { check_all("basic-polarity", 1); }
TEST_CASE("Pattern Explorer's reinforcement, bit for bit") { check_all("basic-reinforcement", 6); }
TEST_CASE("Pattern Explorer's saturation, bit for bit") { check_all("basic-saturation", 6); }
TEST_CASE("Pattern Explorer's spots, bit for bit") { check_all("basic-spots", 4); }
TEST_CASE("Pattern Explorer's benchmark and test, bit for bit") {
    check_all("benchmark", 1);
    check_all("test", 1);
}
TEST_CASE("Pattern Explorer's figures of the 2017 paper, bit for bit") { check_all("paper__", 7); }

TEST_CASE("the golden comparison sees one wrong bit, a NaN and a missing value") {
    const std::vector<double> golden{1.0, -2.0, 0.0};

    const test::Difference same = test::difference({1.0, -2.0, -0.0}, golden);
    const test::Difference bit = test::difference({1.0, -2.0, 5e-324}, golden);
    const test::Difference nan = test::difference({1.0, std::nan(""), 0.0}, golden);

    CHECK(same.unequal == 0);
    CHECK(same.range == 3.0);
    CHECK(bit.unequal == 1);
    CHECK(bit.largest > 0.0);
    CHECK(nan.unequal == 1);
    CHECK(std::isinf(nan.relative()));
    CHECK_THROWS(test::difference({1.0, -2.0}, golden));
    CHECK_THROWS(test::difference({}, {}));
}
