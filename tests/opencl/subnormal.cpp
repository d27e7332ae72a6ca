// Subnormal numbers on the device: the permission to take them for 0, the use it makes of it, and states that hold
// them.
#include "opencl/device/subnormal.hpp"
#include "opencl/backend.hpp"

#include "core/prepattern.hpp"
#include "core/subnormal.hpp"
#include "reference/backend.hpp"
#include "support/opencl_session.hpp"
#include "verify/cases.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace pelage;
using Catch::Contains;

namespace {

std::string options_of(Precision precision, bool fast) {
    OpenclOptions options;
    options.precision = precision;
    options.fast = fast;
    return Session(test::session().info(), options).build_options();
}

}  // namespace

TEST_CASE("every program in single precision may take subnormal numbers for 0, none in double") {
    CHECK_THAT(options_of(Precision::single_, false), Contains("-cl-denorms-are-zero"));
    CHECK_THAT(options_of(Precision::single_, true), Contains("-cl-denorms-are-zero"));
    CHECK_THAT(options_of(Precision::double_, false), !Contains("-cl-denorms-are-zero"));
    CHECK_THAT(options_of(Precision::double_, true), !Contains("-cl-denorms-are-zero"));
}

TEST_CASE("this device and this processor treat subnormal numbers alike") {
    CHECK(keeps_subnormals(test::session()).empty() == processor_flushes());
    CHECK(subnormal_difference(test::session()).empty());
}

TEST_CASE("a subnormal number that is written is read as 0 on both sides, without a step and after one") {
    const Experiment experiment = verify::lattice_case("values/denormal/fused").experiment({33, 30});
    Snapshot state = initial_state(experiment);
    state.conc[3][0] = -1e-40;  // of the chemical that nothing changes
    state.conc[3][1] = 1e-45;
    state.diff[2].assign(state.cells(), 1e-40);
    for (const auto& backend : {reference_backend(Precision::single_), std::unique_ptr<Backend>(opencl_backend({}))}) {
        const auto tissue = backend->make_tissue(experiment, state);
        for (int step = 0; step < 2; ++step) {
            const Snapshot found = tissue->read();
            CHECK(found.conc[3][0] == 0.0);
            CHECK(std::signbit(found.conc[3][0]));
            CHECK(found.conc[3][1] == 0.0);
            CHECK(found.diff[2] == std::vector<double>(state.cells(), 0.0));
            tissue->advance(1);
        }
    }
}

TEST_CASE("what a case of tiny numbers comes to depends on subnormal numbers being 0") {
    const verify::Case& one = verify::lattice_case("values/denormal/fused");
    const Experiment experiment = one.experiment({33, 30});
    Snapshot state = initial_state(experiment);
    one.touch(state);
    const auto single = reference_backend(Precision::single_)->make_tissue(experiment, state);
    const auto twice = reference_backend(Precision::double_)->make_tissue(experiment, state);
    single->advance(20);
    twice->advance(20);
    std::size_t zeros = 0;
    std::size_t others = 0;
    const Snapshot end = single->read();
    const Snapshot kept = twice->read();
    for (std::size_t cell = 0; cell < end.cells(); ++cell) {
        if (end.conc[2][cell] == 0.0 && kept.conc[2][cell] != 0.0) ++zeros;
        if (end.conc[2][cell] != 0.0) ++others;
        REQUIRE((end.conc[2][cell] == 0.0 || std::fabs(end.conc[2][cell]) >= 0x1p-126));
    }
    CHECK(zeros > 50);
    CHECK(others > 50);
}
