// Laws of a tissue on a device: whole steps split anywhere, work is dealt out anyhow, states resume; each changes no
// bit.
#include "core/growable.hpp"
#include "lattice_run.hpp"

#include "core/growth.hpp"
#include "verify/lab.hpp"

#include <cmath>
#include <limits>

using namespace pelage;
using namespace pelage::verify;
using namespace test;

namespace {

const char* const lively[] = {
    "rules/sets/fused",           "rules/restless",      "rules/phases/fused",   "growth/wrap",
    "rates/polarized/moore/wrap", "diffusion/sims/wrap", "rules/draws/published"};

OpenclOptions few_programs() {
    OpenclOptions options;
    options.variants = 1;
    return options;
}

// State after `iterations` in portions of `portion`.
Snapshot grown(OpenclBackend& device, const Experiment& experiment, const Snapshot& before, std::uint64_t iterations,
               std::uint64_t portion) {
    const auto tissue = device.make_tissue(experiment, before);
    for (std::uint64_t done = 0; done < iterations; done += portion) {
        tissue->advance(std::min(portion, iterations - done));
    }
    return tissue->read();
}

}  // namespace

TEST_CASE("advance splits anywhere") {
    const auto device = opencl_backend(few_programs());
    for (const char* name : lively) {
        INFO(name);
        const Case& one = lattice_case(name);
        const Experiment experiment = one.experiment({23, 18});
        const Snapshot before = first_state(one, experiment);

        const Snapshot whole = grown(*device, experiment, before, 60, 60);

        require_equal(whole, grown(*device, experiment, before, 60, 1));
        require_equal(whole, grown(*device, experiment, before, 60, 7));
    }
}

TEST_CASE("the size of a work-group changes no bit") {
    const auto device = opencl_backend(few_programs());
    for (const std::size_t work_group : {std::size_t{2}, std::size_t{5}}) {
        OpenclOptions options = few_programs();
        options.work_group = work_group;
        const auto other = opencl_backend(options);
        for (const char* name : {"rates/polarized/moore/wrap", "diffusion/sims/wrap", "rules/draws/published"}) {
            INFO(name << ", work-groups of " << work_group);
            const Case& one = lattice_case(name);
            const Experiment experiment = one.experiment({83, 18});
            const Snapshot before = first_state(one, experiment);

            require_equal(grown(*device, experiment, before, 30, 30), grown(*other, experiment, before, 30, 30));
        }
    }
}

TEST_CASE("a large lattice, shared out among threads, gives the reference's bits") {
    const auto device = opencl_backend();
    const auto reference = reference_backend(Precision::single_);
    const Case& one = lattice_case("diffusion/nine-point/wrap");
    const Experiment experiment = one.experiment({521, 263});
    const Snapshot before = first_state(one, experiment);
    const auto expected = reference->make_tissue(experiment, before);

    expected->advance(20);

    require_equal(expected->read(), grown(*device, experiment, before, 20, 20));
}

TEST_CASE("what was read can be written, and goes on as if nothing had happened") {
    const auto device = opencl_backend(few_programs());
    for (const char* name : lively) {
        INFO(name);
        const Case& one = lattice_case(name);
        const Experiment experiment = one.experiment({23, 18});
        const Snapshot before = first_state(one, experiment);
        const auto straight = device->make_tissue(experiment, before);
        straight->advance(17);
        const Snapshot middle = straight->read();
        straight->advance(30);

        const auto resumed = device->make_tissue(experiment, middle);
        resumed->advance(30);
        const auto rewritten = device->make_tissue(experiment, before);
        rewritten->advance(40);
        rewritten->write(middle);
        rewritten->advance(30);

        require_equal(straight->read(), resumed->read());
        require_equal(straight->read(), rewritten->read());
    }
}

TEST_CASE("a lattice takes a state of another shape") {
    const auto device = opencl_backend(few_programs());
    const Case& one = lattice_case("diffusion/nine-point/absorbing");
    const Experiment small = one.experiment({13, 7});
    const Experiment large = one.experiment({61, 34});
    const auto tissue = device->make_tissue(large);
    tissue->advance(5);

    tissue->write(initial_state(small));
    tissue->advance(5);

    const auto expected = device->make_tissue(small);
    expected->advance(5);
    require_equal(expected->read(), tissue->read());
    REQUIRE(tissue->cells() == 91);
}

TEST_CASE("every insertion by hand equals the reference's") {
    const auto device = opencl_backend(few_programs());
    const auto reference = reference_backend(Precision::single_);
    const Case& one = lattice_case("growth/absorbing");
    const Experiment experiment = one.experiment({5, 4});
    const Snapshot before = first_state(one, experiment);
    const auto expected = reference->make_tissue(experiment, before);
    const auto found = device->make_tissue(experiment, before);
    for (std::uint32_t i = 0; i < 60; ++i) {
        Insertion insertion{i % 3 != 0, {}};
        const std::size_t lines = insertion.column ? expected->rows() : expected->columns();
        const std::size_t places = insertion.column ? expected->columns() : expected->rows();
        for (std::size_t line = 0; line < lines; ++line) {
            insertion.picks.push_back(static_cast<std::uint32_t>((line * 7 + i * i) % places));
        }

        growable(*expected).expand(insertion);
        growable(*found).expand(insertion);

        require_equal(expected->read(), found->read());
    }
    REQUIRE(found->cells() == 45 * 24);
}

TEST_CASE("numbers that are not finite are found in order of chemical and id") {
    const auto device = opencl_backend(few_programs());
    const Case& one = lattice_case("diffusion/nine-point/wrap");
    const Experiment experiment = one.experiment({37, 29});
    Snapshot state = initial_state(experiment);
    const auto tissue = device->make_tissue(experiment, state);
    REQUIRE_FALSE(tissue->non_finite().has_value());

    state.conc[1][0] = std::numeric_limits<double>::infinity();
    tissue->write(state);
    REQUIRE(tissue->non_finite()->chemical == 1);
    REQUIRE(tissue->non_finite()->cell == 0);

    state.conc[0][1072] = std::numeric_limits<double>::quiet_NaN();
    state.conc[0][700] = -std::numeric_limits<double>::infinity();
    tissue->write(state);
    REQUIRE(tissue->non_finite()->chemical == 0);
    REQUIRE(tissue->non_finite()->cell == 700);
}

TEST_CASE("a rate of its own for every cell may become the same for all") {
    const auto device = opencl_backend(few_programs());
    const auto reference = reference_backend(Precision::single_);
    Lab lab = Lab::matrix(33, 20, Boundary::wrap);
    const auto u = lab.chemical("U", {4, 1}, {0.3, 0.1});
    lab.phase(4).rates[u] = 0.125;
    const Experiment experiment = lab.done();
    const auto expected = reference->make_tissue(experiment);
    const auto found = device->make_tissue(experiment);

    expected->advance(9);
    found->advance(9);

    require_equal(expected->read(), found->read());
}

TEST_CASE("the fast option computes, nearly, the same") {
    OpenclOptions options = few_programs();
    options.fast = true;
    const auto device = opencl_backend(options);
    const auto reference = reference_backend(Precision::single_);
    const Experiment experiment = lattice_case("diffusion/nine-point/wrap").experiment({64, 40});
    const auto expected = reference->make_tissue(experiment);
    const auto found = device->make_tissue(experiment);

    expected->advance(20);
    found->advance(20);

    const Snapshot truth = expected->read();
    const Snapshot state = found->read();
    for (std::size_t i = 0; i < truth.conc.size(); ++i) {
        for (std::size_t k = 0; k < truth.cells(); ++k) {
            REQUIRE(std::fabs(truth.conc[i][k] - state.conc[i][k]) <= 1e-4 * (1 + std::fabs(truth.conc[i][k])));
        }
    }
}

TEST_CASE("a backend bears its device's name and says when it has no double precision") {
    OpenclOptions options;
    options.precision = Precision::double_;
    const auto device = opencl_backend(options);
    const Experiment experiment = lattice_case("diffusion/nine-point/wrap").experiment({3, 3});

    REQUIRE(device->why_not(experiment).empty() == device->device().fp64);
    REQUIRE(device->name() == "opencl: " + device->device().name);
}
