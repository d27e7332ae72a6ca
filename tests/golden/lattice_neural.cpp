// Networks that Mordvintsev et al. published: the states that they lead to in double, and equal bits of both backends
// in float.
#include "io/network.hpp"
#include "lattice_support.hpp"
#include "opencl/backend.hpp"
#include "support/shared.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

namespace {

using namespace pelage;

constexpr double no_bound = std::numeric_limits<double>::infinity();

// [1 2 1; 2 -12 2; 1 2 1] / 16
const StencilWeights published_weights{0.0625, 0.125, 0.0625, 0.125, -0.75, 0.125, 0.0625, 0.125, 0.0625};

Experiment texture(const std::string& model, std::size_t columns, std::size_t rows) {
    Neural neural;
    neural.network = std::make_shared<const Network>(read_network(test::shared("golden/neural/" + model)).network);
    std::vector<test::Substance> substances;
    for (std::size_t i = 0; i < neural.network->chemicals; ++i) {
        substances.push_back({"x" + std::to_string(i), 0.0, {-no_bound, no_bound}});
        neural.species.push_back(i);
    }
    Experiment experiment = test::matrix(columns, rows, Boundary::wrap, Stencil::own, 1.0, substances);
    experiment.weights = published_weights;
    experiment.rules = {test::always(neural)};
    return experiment;
}

// The array has all chemicals of a cell side by side.
std::vector<NpyArray> planes(const NpyArray& cells) {
    const std::size_t chemicals = cells.shape[2];
    std::vector<NpyArray> made(chemicals, {{cells.shape[0], cells.shape[1]}, {}});
    for (std::size_t i = 0; i < cells.values.size(); ++i) made[i % chemicals].values.push_back(cells.values[i]);
    return made;
}

// The arrays are kept in float, which rounds a number by less than this share of it.
constexpr double kept_digits_of_float = 1e-7;

void check_bits(const Experiment& experiment, const std::vector<NpyArray>& seed) {
    const auto reference = test::start(experiment, seed, Precision::single_);
    const auto device = opencl_backend()->make_tissue(reference->experiment(), reference->read());
    for (const std::uint64_t steps : {1u, 9u, 15u}) {
        reference->advance(steps);
        device->advance(steps);
        INFO("after " << reference->iteration());
        REQUIRE(verify::differences(reference->read(), device->read()).empty());
    }
}

void check_model(const std::string& model) {
    if (test::shared_missing("golden/neural/" + model)) return;
    const NpyArray seed = test::golden("neural/seed_64");
    const Experiment experiment = texture(model, seed.shape[1], seed.shape[0]);
    check_bits(experiment, planes(seed));
    const auto tissue = test::start(experiment, planes(seed));
    for (const unsigned at : {1u, 10u, 100u}) {
        tissue->advance(at - tissue->iteration());
        const std::vector<NpyArray> golden = planes(test::golden("neural/" + model + "/state_" + std::to_string(at)));
        const Snapshot found = tissue->read();
        double largest = 0.0;
        for (std::size_t i = 0; i < golden.size(); ++i) {
            const test::Difference difference = test::difference(found.conc[i], golden[i].values);
            CHECK(difference.range > 0.0);
            largest = std::max(largest, difference.largest / std::max(difference.range, difference.magnitude));
        }
        INFO(model << " after " << at);
        CHECK(largest < kept_digits_of_float);
    }
}

}  // namespace

TEST_CASE("neural textures: banded") { check_model("banded_0037"); }
TEST_CASE("neural textures: chequered") { check_model("chequered_0121"); }
TEST_CASE("neural textures: grid") { check_model("grid_0135"); }
TEST_CASE("neural textures: interlaced") { check_model("interlaced_0172"); }
TEST_CASE("neural textures: lined") { check_model("lined_0118"); }
TEST_CASE("neural textures: lizard") { check_model("lizard"); }
TEST_CASE("neural textures: polka-dotted") { check_model("polka-dotted_0121"); }
