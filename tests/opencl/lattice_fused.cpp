// Fused iterations: the bits of the reference, however deep the passes and however the lattice is shared out.
#include "lattice_run.hpp"
#include "opencl/stream_step.hpp"
#include "support/lab.hpp"

using namespace pelage;
using namespace test;

namespace {

OpenclOptions fused(std::size_t width = 0) {
    OpenclOptions made;
    made.fusion = Fusion::always;
    made.width = width;
    return made;
}

// Two chemicals that react and one that follows them by rules with draws: all that a fused program may hold.
Experiment busy(std::size_t columns, std::size_t rows, Boundary boundary) {
    Lab lab = Lab::matrix(columns, rows, boundary);
    const std::size_t u = lab.chemical("U", {4, 2}, {5, 0}, {0, 6});
    const std::size_t v = lab.chemical("V", {4, 2}, {1, 0});
    const std::size_t m = lab.chemical("M", {1, 1}, {0, 0}, unbounded);
    lab.rule(react(Model::turing, u, v, {16, 12}));
    lab.rule(change(v, number(0.005), 0.005), compare(quantity(Quantity::row), Comparison::less, number(5)));
    lab.rule(And{}, compare(quantity(Quantity::column), Comparison::greater, number(5)));
    lab.rule(change(m, quantity(Quantity::concentration, u)), Probability{number(0.3)});
    lab.rule(Set{Target::concentration, m, quantity(Quantity::random)},
             compare(quantity(Quantity::x), Comparison::less, quantity(Quantity::y)));
    return lab.time_step(0.01).done();
}

Snapshot run(Backend& backend, const Experiment& experiment, std::vector<std::uint64_t> parts) {
    const auto tissue = backend.make_tissue(experiment);
    for (const std::uint64_t part : parts) tissue->advance(part);
    return tissue->read();
}

}  // namespace

TEST_CASE("fused: stencils and boundaries") {
    check_cases("diffusion/nine-point", fused());
    check_cases("diffusion/five-point/no-flux", fused());
    check_cases("diffusion/sims/absorbing", fused());
}
TEST_CASE("fused: rules") { check_cases("rules/", fused()); }
TEST_CASE("fused: growth") { check_cases("growth/", fused()); }

TEST_CASE("fused: several bands and strips, odd remainders") {
    const auto device = opencl_backend(fused());
    const auto reference = reference_backend(Precision::single_);
    for (const Boundary boundary : {Boundary::wrap, Boundary::no_flux, Boundary::absorbing}) {
        const Experiment experiment = busy(601, 97, boundary);

        const Snapshot expected = run(*reference, experiment, {45});

        require_equal(expected, run(*device, experiment, {45}));
        require_equal(expected, run(*device, experiment, {1, 16, 17, 2, 9}));
        REQUIRE(mistrusted(initial_state(experiment), expected).empty());
    }
}

TEST_CASE("fused: one work-group alone takes many passes a launch") {
    const auto device = opencl_backend(fused());
    const Experiment experiment = busy(61, 67, Boundary::no_flux);

    require_equal(run(*reference_backend(Precision::single_), experiment, {500}), run(*device, experiment, {500}));
}

TEST_CASE("fused: double, and one cell a vector") {
    OpenclOptions twice = fused();
    twice.precision = Precision::double_;
    const Experiment experiment = busy(41, 37, Boundary::wrap);

    require_equal(run(*reference_backend(Precision::double_), experiment, {40}),
                  run(*opencl_backend(twice), experiment, {40}));
    require_equal(run(*reference_backend(Precision::single_), experiment, {40}),
                  run(*opencl_backend(fused(1)), experiment, {40}));
}

TEST_CASE("fused: what keeps a program from being fused is said in words") {
    LatticePlan plan;
    plan.rates = {RateKind::uniform, RateKind::none};
    RuleUse maps;
    maps.mappings_read.insert(0);
    RuleUse ages;
    ages.quantities.insert(Quantity::age);

    CHECK(why_not_fused(plan, RuleUse{}).empty());
    CHECK(why_not_fused(plan, maps) == "mappings outlast an iteration");
    CHECK(why_not_fused(plan, ages) == "rules read NEIGHBORS, AGE or BIRTH");
    plan.rates[1] = RateKind::per_cell;
    CHECK(why_not_fused(plan, RuleUse{}) == "diffusion rates differ between cells");
    plan.arithmetic = Arithmetic::published;
    CHECK(why_not_fused(plan, RuleUse{}) == "a sqr_grid keeps the published order of operations");
}
