// Fields of blobs on meshes: their shape, and both backends' bits where they start a run and where rules read them; the
// bits in volumes, too.
#include "core/fields.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/equal_runs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

using namespace pelage;

namespace {

Experiment with_blobs(const std::string& fields, const std::string& rest, const std::string& create) {
    return parse_experiment(
        "define chemical U floor none\ndefine chemical V floor none\n" + fields + "use seed 5\n" + create + rest,
        "spots.pex", ".");
}

std::vector<double> blobs_alone(const std::string& define, const std::string& create = "create icosphere 3\n") {
    return initial_state(with_blobs("define field f " + define + "\nuse chemical U conc (f)\n", "", create)).conc[0];
}

}  // namespace

TEST_CASE("a blob on a mesh falls off with the straight way from its vertex") {
    for (const char* create : {"create icosphere 3\n", "create torus 40 21 scale 0.5\n"}) {
        const Experiment experiment =
            with_blobs("define field f blobs 1 sigma 2.5\nuse chemical U conc (f)\n", "", create);
        const std::vector<double> one = initial_state(experiment, Precision::double_).conc[0];
        const auto& vertices = std::get<MeshCells>(space_of(experiment)).surface->mesh.vertices;
        const auto top = static_cast<std::size_t>(std::max_element(one.begin(), one.end()) - one.begin());
        double worst = 0.0;
        for (std::size_t i = 0; i < one.size(); ++i) {
            const double far = length(vertices[i] - vertices[top]);
            worst = std::max(worst, std::abs(one[i] - std::exp(-far * far / (2 * 2.5 * 2.5))));
        }
        CHECK(one[top] == 1.0);
        CHECK(worst < 1e-13);
    }
}

TEST_CASE("blobs on a mesh add up, and each field and each seed has its own") {
    CHECK(blobs_alone("blobs 0 sigma 2") == std::vector<double>(642, 0.0));
    const std::vector<double> one = blobs_alone("blobs 1 sigma 1"), nine = blobs_alone("blobs 9 sigma 1");
    for (std::size_t i = 0; i < one.size(); ++i) CHECK(nine[i] >= one[i]);  // the first of them is that one
    CHECK(std::ranges::count_if(nine, [](double value) { return value >= 1.0; }) > 4);
    CHECK(blobs_alone("blobs 1 sigma 1\ndefine field g blobs 1 sigma 1") == one);
    const std::vector<double> second =
        initial_state(with_blobs("define field g blobs 1 sigma 1\ndefine field f blobs 1 sigma 1\n"
                                 "use chemical U conc (f)\n",
                                 "", "create icosphere 3\n"))
            .conc[0];
    CHECK(second != one);
}

TEST_CASE("both backends have the same bits where blobs start a run and rules read them") {
    struct One {
        const char* create;
        Precision precision;
        std::size_t cells;
    };
    for (const One& one :
         {One{"create icosphere 2\n", Precision::single_, 162}, One{"create icosphere 2\n", Precision::double_, 162},
          One{"create volume 9 7 5 wrap\n", Precision::single_, 315}}) {
        INFO(one.create);
        Experiment experiment = with_blobs(
            "define field bent (0.01 * X)\ndefine field f blobs 7 sigma 2\ndefine field unread blobs 3 sigma 1\n"
            "define field g (2 * f + bent)\ndefine field h blobs 4 sigma 3\n"
            "use chemical U conc (1 + g) diff 0.1\nuse chemical V conc (h) diff (0.05 + 0.01 * f)\n",
            "rule always react U by (0.1 * h - 0.05 * U) V by (0.01 * g * U)\nrule if f > 0.5 change V conc 0.125\n",
            one.create);
        experiment.stop_at = 20;
        OpenclOptions options;
        options.precision = one.precision;
        const verify::EqualRun run =
            verify::run_both(experiment, *reference_backend(one.precision), *opencl_backend(options), 5);
        CHECK(run.difference.empty());
        CHECK(run.finite);
        CHECK(run.cells == one.cells);
    }
}

TEST_CASE("blobs among free cells are refused") {
    CHECK_THROWS_WITH(with_blobs("define field f blobs 3 sigma 1\n", "", "create hex_grid 4 4\n"),
                      Catch::StartsWith("spots.pex:3:") && Catch::Contains("free cells"));
}
