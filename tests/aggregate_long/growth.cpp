// Long growth: the same sites on both backends, and how aggregates fill the plane.
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "stats/dimension.hpp"
#include "verify/compare.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace pelage;

namespace {

Experiment charges(std::size_t side, const std::string& seed, const std::string& eta, int draws,
                   const std::string& more = {}) {
    return parse_experiment(
        fmt::format("define chemical order\ndefine chemical phi\nuse seed {}\ncreate charges {} {}\n"
                    "set cells where ({}) chemical order conc 1\nrule always aggregate order phi eta {}{}\n",
                    draws, side, side, seed, eta, more),
        "charges.pex", ".");
}

void check_equal(const Experiment& experiment, std::uint64_t steps) {
    const auto reference = reference_backend(Precision::single_)->make_tissue(experiment);
    const auto device = opencl_backend()->make_tissue(experiment);
    for (std::uint64_t part = 0; part < 4; ++part) {
        reference->advance(steps / 4);
        device->advance(steps / 4);
        INFO("after " << reference->iteration());
        REQUIRE(verify::differences(reference->read(), device->read()).empty());
    }
}

double dimension(const std::string& eta, int draws, const std::string& more = {}) {
    const auto tissue = opencl_backend()->make_tissue(charges(1001, "COLUMN == 500 and ROW == 500", eta, draws, more));
    tissue->advance(10'000);
    std::vector<double> taken = tissue->read().conc[0];
    for (double& order : taken) order = std::min(order, 1.0);
    return stats::dimension_of({taken, 1001, 1001, false});
}

}  // namespace

TEST_CASE("both backends take the same 20,000 sites from a point, and 10,000 from a circle and a cross") {
    const std::string eta = GENERATE("1", "3", "6", "10");
    INFO("eta " << eta);
    check_equal(charges(400, "COLUMN == 200 and ROW == 200", eta, 1), 20'000);
    check_equal(charges(400, "abs(hypot(COLUMN - 200, ROW - 200) - 50) < 0.5", eta, 2), 10'000);
    check_equal(charges(400, "COLUMN == 200 or ROW == 200", eta, 3), 10'000);
}

TEST_CASE("the larger eta, the less an aggregate fills the plane") {
    const auto mean = [](const std::string& eta) {
        double sum = 0.0;
        for (int draws = 1; draws <= 5; ++draws) sum += dimension(eta, draws);
        return sum / 5.0;
    };
    const double one = mean("1"), three = mean("3"), six = mean("6");
    WARN("dimensions of eta 1, 3, 6: " << one << ", " << three << ", " << six);
    CHECK(one < 2.0);
    CHECK(one > three);
    CHECK(three > six);
    CHECK(six > 1.0);
}

TEST_CASE("both backends take the same sites with a far field") {
    check_equal(charges(400, "COLUMN == 200 and ROW == 200", "3", 4, " far-field"), 6'000);
    check_equal(charges(600, "abs(hypot(COLUMN - 300, ROW - 300) - 150) < 0.5", "6", 5, " far-field"), 3'000);
}

TEST_CASE("aggregates with a far field fill the plane as exact ones do") {
    for (const char* eta : {"1", "3", "6"}) {
        double exact = 0.0, far = 0.0;
        for (int draws = 1; draws <= 5; ++draws) {
            exact += dimension(eta, draws) / 5.0;
            far += dimension(eta, draws, " far-field") / 5.0;
        }
        WARN("dimensions of eta " << eta << ": " << exact << ", with a far field " << far);
        CHECK(std::abs(exact - far) < 0.05);
    }
}
