// McConnell's Gray-Scott program, run in double, against the double reference.
#include "lattice_support.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>

namespace {

using namespace pelage;

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double kept_digits = 1e-6;  // of the range: the arrays are kept in float

// A has no limit and B no floor; outside the picture both read as 0; there is no time step in the equation.
Experiment art(std::size_t columns, std::size_t rows, double feed, const Operand& kill) {
    std::vector<test::Substance> substances{{"A", 1.0, {0.0, unbounded}}, {"B", 0.5, {-unbounded, 1.0}}};
    if (kill.quantity == Quantity::concentration) substances.push_back({"K", 0.0, {-unbounded, unbounded}});
    Experiment experiment = test::matrix(columns, rows, Boundary::absorbing, Stencil::sims, 1.0, substances);
    experiment.rules = {
        test::always(React{model_named("gray-scott"), {0, 1}, Operand::number(1.0), {Operand::number(feed), kill}})};
    return experiment;
}

void check(const Tissue& tissue, std::size_t chemical, const std::string& array, double allowed = kept_digits) {
    INFO(array);
    const test::Difference difference =
        test::difference(tissue.read().conc[chemical], test::golden("gray_scott/" + array).values);
    CHECK(difference.range > 0.0);
    CHECK(difference.largest < allowed * difference.range);
}

void check_preset(const std::string& name) {
    if (test::shared_missing("golden/gray_scott/gs_" + name + "_256")) return;
    std::ifstream file(test::shared("golden/gray_scott/report.json"));
    const nlohmann::json preset = nlohmann::json::parse(file).at(name);
    const std::string folder = "gs_" + name + "_256/";
    const NpyArray a = test::golden("gray_scott/" + folder + "A0");
    const NpyArray b = test::golden("gray_scott/" + folder + "B0");
    const Experiment experiment =
        art(a.shape[1], a.shape[0], preset.at("F"), Operand::number(preset.at("k").get<double>()));
    const auto tissue = test::start(experiment, {a, b});
    for (const std::uint64_t at : {1u, 10u, 100u, 1000u}) {
        tissue->advance(at - tissue->iteration());
        check(*tissue, 0, folder + "A" + std::to_string(at));
        check(*tissue, 1, folder + "B" + std::to_string(at));
    }
}

}  // namespace

TEST_CASE("Gray-Scott mitosis") { check_preset("mitosis"); }
TEST_CASE("Gray-Scott maze") { check_preset("maze"); }

TEST_CASE("Gray-Scott with a kill rate that differs from cell to cell") {
    if (test::shared_missing("golden/gray_scott/gs_bias_256")) return;
    NpyArray a = test::golden("gray_scott/gs_init_maps/B_mode0_256");
    const NpyArray b = a;
    a.values.assign(a.values.size(), 1.0);
    for (const std::string mode : {"2", "3", "4", "5"}) {
        const NpyArray kill = test::golden("gray_scott/gs_bias_256/kill_mode" + mode);
        const auto tissue = test::start(art(a.shape[1], a.shape[0], 0.0367, Operand::concentration(2)), {a, b, kill});
        tissue->advance(300);
        check(*tissue, 1, "gs_bias_256/B300_mode" + mode, 4 * kept_digits);  // the kill rates too are kept in float
    }
}
