// Networks: the bits of the reference on every path, and programs that depend on their size alone.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "opencl/rules/emit_rules.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace pelage;

namespace {

Experiment asked(const std::string& rule, const std::string& edge = "wrap") {
    const std::string text =
        "define chemicals x 8 floor none\ndefine stencil 3x3 0.0625 0.125 0.0625 0.125 -0.75 0.125 0.0625 0.125 "
        "0.0625\n"
        "define field dots blobs 9 sigma 2\nuse chemical x0 conc (dots)\nuse chemical x5 conc 0 dev 0.25\ncreate "
        "matrix 37 11 " +
        edge + "\n" + rule + "\n";
    return parse_experiment(text, "networks.pex", PELAGE_SOURCE "/experiments/neural");
}

}  // namespace

TEST_CASE("networks have the reference's bits on every path") {
    OpenclOptions options;
    options.path = GENERATE(Path::step, Path::shared, Path::streamed, Path::tiled);
    options.precision = options.path == Path::shared ? Precision::double_ : Precision::single_;
    const Experiment experiment = asked(
        "rule always react all neural \"tiny.npz\" rate (1 - 0.5 * dots) diffusion (0.5 + 0.5 * dots)", "no-flux");
    const Snapshot initial = initial_state(experiment, options.precision);
    const auto expected = reference_backend(options.precision)->make_tissue(experiment, initial);
    const auto found = opencl_backend(options)->make_tissue(experiment, initial);
    for (const std::uint64_t steps : {1, 2, 9, 12}) {
        expected->advance(steps);
        found->advance(steps);
        REQUIRE(verify::differences(expected->read(), found->read()).empty());
    }
    CHECK_FALSE(verify::differences(initial, found->read()).empty());
}

TEST_CASE("a network by hand: one hidden value") {
    // act(z) = z / (1 + e^-5z) of z = x0 / 2 + 1/4; x3 gets twice that, and x0 diffuses an eighth.
    Experiment experiment = parse_experiment(
        "define chemicals x 4 floor none\nuse chemical x0 conc 0.5\ncreate matrix 3 3 wrap\n"
        "set cell 4 chemical x0 conc 1.5\ndefine time_step 0.5\n",
        "hand.pex", ".");
    Neural neural;
    neural.species = {0, 1, 2, 3};
    neural.network = std::make_shared<const Network>(make_network(4, 1, {0.5, 0, 0, 0}, {0.25}, {0, 0, 0, 2}, "hand"));
    Rule rule;
    rule.action = neural;
    experiment.rules.push_back(rule);
    const auto act = [](double z) { return z / (1 + std::exp(-5 * z)); };
    for (const bool device : {false, true}) {
        OpenclOptions options;
        options.precision = Precision::double_;
        const auto backend = device ? opencl_backend(options) : reference_backend(Precision::double_);
        const auto tissue = backend->make_tissue(experiment, initial_state(experiment, Precision::double_));
        tissue->advance(1);
        const Snapshot after = tissue->read();
        CHECK(after.conc[3][4] == Approx(0.5 * 2 * act(1.0)).epsilon(1e-14));
        CHECK(after.conc[3][0] == Approx(0.5 * 2 * act(0.5)).epsilon(1e-14));
        CHECK(after.conc[0][4] == Approx(1.5 - 0.5 * 0.125 * 20.0 / 6).epsilon(1e-14));
        CHECK(after.conc[0][1] == Approx(0.5 + 0.5 * 0.125 * 4.0 / 6).epsilon(1e-14));
        CHECK(after.conc[1][4] == 0.0);
    }
}

TEST_CASE("another network of the same size is the same program, another rate too") {
    Experiment one = asked("rule always react all neural \"tiny.npz\" rate 0.5");
    const Experiment faster = asked("rule always react all neural \"tiny.npz\" rate 2 diffusion 0.25");
    Experiment other = one;
    Neural& neural = std::get<Neural>(other.rules[0].action);
    Network changed = *neural.network;
    for (double& weight : changed.first) weight *= 0.5;
    neural.network = std::make_shared<const Network>(changed);
    const auto text = [](const Experiment& experiment) { return emit_rules(experiment, {true}, Precision::single_); };
    CHECK(text(one).rules == text(other).rules);
    CHECK(text(one).rules == text(faster).rules);
    CHECK(text(one).numbers.declarations(4) == text(other).numbers.declarations(4));
    CHECK_THROWS(text(one).numbers.declarations(3));  // its tables could not be read four numbers at a time
    CHECK(text(one).numbers.values() != text(other).numbers.values());
    CHECK(text(one).numbers.values().size() > 8 * 33 * 2);
}
