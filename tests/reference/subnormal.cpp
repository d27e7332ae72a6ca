// Subnormal numbers are 0 on the reference, in and out, in single precision alone.
#include "core/subnormal.hpp"
#include "reference/lab.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace pelage;

namespace {

const std::vector<double> tiny{0x1p-130, -0x1p-140, 0x1p-126, -0x1p-126, 1};

Snapshot started(const Experiment& experiment) {
    Snapshot state = test::blank(experiment);
    state.conc[0] = tiny;
    return state;
}

Experiment line() {
    Experiment experiment = test::matrix(5, 1);
    experiment.phases[0].time_step = 0x1p-4;
    return experiment;
}

}  // namespace

TEST_CASE("a subnormal number that is written is read as 0") {
    const Experiment experiment = line();

    const Snapshot single = test::start(experiment, started(experiment), Precision::single_)->read();
    const Snapshot twice = test::start(experiment, started(experiment), Precision::double_)->read();

    CHECK(single.conc[0] == std::vector<double>{0, 0, 0x1p-126, -0x1p-126, 1});
    CHECK_FALSE(std::signbit(single.conc[0][0]));
    CHECK(std::signbit(single.conc[0][1]));
    CHECK(twice.conc[0] == tiny);
}

TEST_CASE("a subnormal result is 0, and so is a subnormal number of a rule") {
    if (!processor_flushes()) return;
    Experiment experiment = line();
    Snapshot state = started(experiment);
    state.conc[0] = {0x1.8p-126, 0x1.8p-126, 0x1.8p-126, 0x1.8p-126, 0x1p-125};
    experiment.rules = {test::rule(Change{Target::concentration, 0, test::number(-0x1p-126)}),
                        test::rule(Change{Target::concentration, 0, test::number(1e-40)})};

    CHECK(test::after(1, experiment, state, Precision::single_).conc[0] == std::vector<double>{0, 0, 0, 0, 0x1p-126});
    CHECK(test::after(1, experiment, state, Precision::double_).conc[0][0] == 0x1p-127 + 1e-40);
}

TEST_CASE("stepping gives the mode of the processor back") {
    const volatile float small = 0x1p-120f;
    const Experiment experiment = line();

    test::start(experiment, started(experiment), Precision::single_)->advance(3);

    CHECK(small * 0x1p-20f != 0.0f);
}
