// The cascades of Girgin & Sacan against the double reference: a Turing pattern whose cells set the stage for another.
#include "lattice_support.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

namespace {

using namespace pelage;

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-6;  // of the range: the arrays are kept in float
constexpr std::size_t a = 0, b = 1, beta = 2, frozen = 3;

NpyArray array(const std::string& name) { return test::golden("cascades/turing_100/" + name); }

// da = 0.1 lap a + k (16 - a b), db = 0.02 lap b + k (a b - b - 12 - beta); cells where frozen is 1 keep both.
Experiment cascade(double k) {
    Experiment experiment =
        test::matrix(100, 100, Boundary::wrap, Stencil::five_point, 1.0,
                     {{"a", 0.1, {}}, {"b", 0.02, {}}, {"beta", 0.0, {0.0, none}}, {"frozen", 0.0, {}}});
    experiment.rules = {test::always(React{
        model_named("turing"), {a, b}, Operand::number(k), {Operand::number(16.0), Operand::concentration(beta)}})};
    for (const std::size_t chemical : {a, b}) {
        Rule keep = test::always(Set{Target::concentration, chemical, Operand::concentration(chemical)});
        keep.condition = Compare{Operand::concentration(frozen), Comparison::equal, Operand::number(1.0)};
        experiment.rules.push_back(keep);
    }
    return experiment;
}

NpyArray beta_field(const std::string& name) {
    NpyArray field = array(name);
    for (double& value : field.values) value += 12.0;
    return field;
}

NpyArray everywhere(double value) { return {{100, 100}, std::vector<double>(10000, value)}; }

void check(Tissue& tissue, std::uint64_t at, const std::string& name, const std::string& suffix, double allowed) {
    tissue.advance(at - tissue.iteration());
    const Snapshot now = tissue.read();
    double range = 0.0;
    for (const std::size_t chemical : {a, b}) {
        const std::string full = name + "_" + (chemical == a ? "a" : "b") + suffix;
        INFO(full);
        const test::Difference difference = test::difference(now.conc[chemical], array(full).values);
        range = std::max(range, difference.range);
        CHECK(difference.largest <= allowed * std::max(difference.range, 1.0));
    }
    CHECK(range > 0.0);
}

void check_second_stage(const std::string& name, bool reset) {
    if (test::shared_missing("golden/cascades/turing_100")) return;
    const NpyArray mask = array("casc_mask");
    NpyArray start_b = array("casc1_b");
    for (std::size_t cell = 0; cell < mask.values.size(); ++cell) {
        if (reset && mask.values[cell] != 0.0) start_b.values[cell] = 4.0;
    }
    const auto tissue = test::start(cascade(0.01), {array("casc1_a"), start_b, beta_field("beta_cascade"), mask});
    check(*tissue, 1, name, "1", tolerance);
    check(*tissue, 100, name, "100", tolerance);
    if (!reset) check(*tissue, 10000, name, "", tolerance);
}

}  // namespace

TEST_CASE("cascades: spots from a random beta") {
    if (test::shared_missing("golden/cascades/turing_100")) return;
    const auto tissue =
        test::start(cascade(0.02), {everywhere(4.0), everywhere(4.0), beta_field("beta_spot"), everywhere(0.0)});
    for (const std::uint64_t at : {1u, 10u, 100u}) check(*tissue, at, "spot", std::to_string(at), tolerance);
    // A perturbation of 1e-7 moves the spots by up to 1e-3 of the range while they form (report.json).
    check(*tissue, 1000, "spot", "1000", 1e-3);
}

TEST_CASE("cascades: the cheetah's second stage") { check_second_stage("cheetah", false); }

TEST_CASE("cascades: the leopard's second stage") { check_second_stage("leopard", true); }
