// Streamed iterations: the bits of the reference, however deep the passes and however the lattice is shared out.
#include "busy_lattice.hpp"
#include "lattice_run.hpp"
#include "opencl/lattice/explain.hpp"

using namespace pelage;
using namespace pelage::verify;
using namespace test;

namespace {

OpenclOptions streamed(std::size_t width = 0) {
    OpenclOptions made;
    made.path = Path::streamed;
    made.variants = 1;  // few programs: they take long to compile
    made.width = width;
    return made;
}

}  // namespace

TEST_CASE("streamed: a reaction may read a chemical that nothing changes") {
    Lab lab = Lab::matrix(61, 37, Boundary::wrap);
    const std::size_t u = lab.chemical("U", {0.5, 0.5}, {0.2, 0}, unbounded);
    const std::size_t v = lab.chemical("V", {0.5, 0.5}, {0, 0}, unbounded);
    lab.rule(react(model_named("cubic"), {u, v}, {0.1, 0.45, 0.95}));
    const Experiment experiment = lab.time_step(0.1).done();

    require_equal(run(*reference_backend(Precision::single_), experiment, {40}),
                  run(*opencl_backend(streamed()), experiment, {40}));
}
TEST_CASE("streamed: several bands and strips, odd remainders") {
    const auto device = opencl_backend(streamed());
    const auto reference = reference_backend(Precision::single_);
    for (const Boundary boundary : {Boundary::wrap, Boundary::no_flux, Boundary::absorbing}) {
        const Experiment experiment = busy(601, 97, boundary);

        const Snapshot expected = run(*reference, experiment, {45});

        require_equal(expected, run(*device, experiment, {45}));
        require_equal(expected, run(*device, experiment, {1, 16, 17, 2, 9}));
        REQUIRE(mistrusted(initial_state(experiment), expected).empty());
    }
}

TEST_CASE("streamed: one work-group alone takes many passes a launch") {
    const auto device = opencl_backend(streamed());
    const Experiment experiment = busy(61, 67, Boundary::no_flux);

    require_equal(run(*reference_backend(Precision::single_), experiment, {500}), run(*device, experiment, {500}));
}

TEST_CASE("streamed: strips of whole rows share the passes of a launch") {
    const auto device = opencl_backend(streamed());
    const auto reference = reference_backend(Precision::single_);
    for (const Boundary boundary : {Boundary::wrap, Boundary::no_flux, Boundary::absorbing}) {
        for (const std::size_t columns : {208u, 213u}) {
            CAPTURE(columns);
            const Experiment experiment = busy(columns, 201, boundary);

            const Snapshot expected = run(*reference, experiment, {90});

            require_equal(expected, run(*device, experiment, {90}));
            require_equal(expected, run(*device, experiment, {1, 40, 17, 32}));
        }
    }
}

TEST_CASE("streamed: double, and one cell a vector") {
    OpenclOptions twice = streamed();
    twice.precision = Precision::double_;
    const Experiment experiment = busy(41, 37, Boundary::wrap);

    require_equal(run(*reference_backend(Precision::double_), experiment, {40}),
                  run(*opencl_backend(twice), experiment, {40}));
    require_equal(run(*reference_backend(Precision::single_), experiment, {40}),
                  run(*opencl_backend(streamed(1)), experiment, {40}));
}

TEST_CASE("shared steps: strips that wait for each other, and one launch an iteration, give the same bits") {
    OpenclOptions shared;
    shared.path = Path::shared;
    OpenclOptions step;
    step.path = Path::step;
    for (const Boundary boundary : {Boundary::wrap, Boundary::no_flux, Boundary::absorbing}) {
        const Experiment experiment = busy(131, 97, boundary);
        const Snapshot expected = run(*reference_backend(Precision::single_), experiment, {300});

        require_equal(expected, run(*opencl_backend(shared), experiment, {300}));
        require_equal(expected, run(*opencl_backend(shared), experiment, {7, 100, 1, 192}));
        require_equal(expected, run(*opencl_backend(step), experiment, {300}));
    }
}

TEST_CASE("streamed: every set of rules of an experiment is explained") {
    const Experiment experiment = busy(16, 16, Boundary::wrap);

    const auto sentences =
        explain_lattice(experiment, initial_state(experiment), Precision::single_, usual_processor());

    REQUIRE(sentences.size() == 1);
    CHECK(sentences.front().find("from iteration 0, the rules of lines") == 0);
    CHECK(sentences.front().find(": shared, ") != std::string::npos);
    const auto tissue = opencl_backend(streamed())->make_tissue(experiment);
    tissue->advance(2);
    REQUIRE(tissue->report().size() == 1);
    CHECK(tissue->report().front().find("from iteration 0: streamed, up to ") == 0);
}
