// Lattices that run together have the bits of those that run alone.
#include "busy_lattice.hpp"
#include "core/error.hpp"
#include "core/seed.hpp"
#include "language/parse.hpp"
#include "lattice_run.hpp"
#include "opencl/lattice/choice.hpp"
#include "opencl/lattice/structure.hpp"
#include "verify/equal_runs.hpp"
#include "verify/random_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pelage;
using namespace pelage::verify;
using namespace test;
using Catch::Matchers::Contains;

namespace {

BatchStart start_of(Experiment experiment, Precision precision = Precision::single_) {
    Snapshot state = initial_state(experiment, precision);
    return {std::make_shared<const Experiment>(std::move(experiment)), std::move(state)};
}

// With phases that change rates and bounds, and numbers that no other has.
Experiment restless(std::size_t nth, Boundary boundary) {
    Experiment experiment = busy(43, 29, boundary);
    const double part = 1.0 - 0.03 * static_cast<double>(nth);
    experiment.phases.front().time_step *= part;
    experiment.phases.push_back(experiment.phases.front());
    experiment.phases.back().begin = 9;
    experiment.phases.back().rates[0] = 3.0 * part;
    experiment.phases.back().bounds[1].limit = 4.5 * part;
    for (Rule& rule : experiment.rules) {
        if (auto* const react = std::get_if<React>(&rule.action)) react->parameters[0].value *= part;
    }
    experiment.seed = (std::int64_t{5} << 33) + static_cast<std::int64_t>(nth);
    return experiment;
}

OpenclOptions by(Path path, Precision precision = Precision::single_, std::size_t work_group = 0) {
    OpenclOptions options;
    options.path = path;
    options.precision = precision;
    options.work_group = work_group;
    options.guarded = true;
    return options;
}

}  // namespace

TEST_CASE("batch: each lattice ends in the bits of the reference, on every path, whatever else runs beside it") {
    struct How {
        OpenclOptions options;
        Boundary boundary = Boundary::wrap;
    };
    const auto [options, boundary] =
        GENERATE(How{by(Path::automatic), Boundary::wrap}, How{by(Path::step), Boundary::no_flux},
                 How{by(Path::step, Precision::single_, 3), Boundary::absorbing},
                 How{by(Path::tiled), Boundary::no_flux}, How{by(Path::tiled, Precision::double_), Boundary::absorbing},
                 How{by(Path::streamed, Precision::double_), Boundary::wrap});
    INFO(word(options.path) << ", " << word(boundary));
    const auto device = opencl_backend(options);
    const auto reference = reference_backend(options.precision);
    std::vector<BatchStart> starts;
    std::vector<std::unique_ptr<Tissue>> alone;
    for (std::size_t nth = 0; nth < 6; ++nth) {
        starts.push_back(start_of(restless(nth, boundary), options.precision));
        alone.push_back(reference->make_tissue(*starts.back().experiment, starts.back().state));
    }

    const auto batch = device->make_batch(starts);
    std::vector<std::size_t> running{0, 1, 2, 3, 4, 5};
    for (const std::uint64_t part : {1u, 6u, 5u, 4u}) {
        batch->advance(part);
        for (const std::size_t nth : running) {
            INFO("lattice " << nth);
            alone[nth]->advance(part);
            require_equal(alone[nth]->read(), batch->read(nth));
        }
        batch->end(running[running.size() / 2]);
        running.erase(running.begin() + static_cast<std::ptrdiff_t>(running.size() / 2));
    }
    CHECK(batch->iteration() == 16);
    CHECK(alone[0]->read().conc != alone[5]->read().conc);
}

TEST_CASE("batch: lattices drawn at random from the whole language run alike together and alone") {
    RandomLimits limits;
    limits.cells = 150;
    limits.iterations = 24;
    limits.chemicals = 4;
    limits.rules = 6;
    limits.free_cells = limits.volume = limits.mesh = limits.charges = false;
    std::size_t batches = 0;
    const std::size_t wanted = long_form() ? 60 : 8;
    for (std::uint64_t seed = 7000; batches < wanted; ++seed) {
        const std::string text = random_experiment(seed, limits);
        const auto device = opencl_backend(by(seed % 2 == 0 ? Path::step : Path::tiled));
        std::vector<BatchStart> starts;
        for (std::int64_t nth = 0; nth < 3; ++nth) {
            Experiment experiment = parse_experiment(text, "random.pex", "");
            for (Phase& phase : experiment.phases) phase.time_step *= 1.0 - 0.01 * static_cast<double>(nth);
            experiment.seed = 100 + nth;
            starts.push_back(start_of(std::move(experiment)));
        }
        const auto structure = [&](const BatchStart& start) {
            return device->structure(*start.experiment, start.state);
        };
        if (structure(starts[0]).empty()) continue;
        if (structure(starts[1]) != structure(starts[0]) || structure(starts[2]) != structure(starts[0])) continue;
        ++batches;
        INFO("seed " << seed << "\n" << text);
        const auto batch = device->make_batch(starts);
        batch->advance(5);
        batch->advance(19);
        for (std::size_t nth = 0; nth < starts.size(); ++nth) {
            const auto tissue =
                reference_backend(Precision::single_)->make_tissue(*starts[nth].experiment, starts[nth].state);
            tissue->advance(24);
            Snapshot expected = tissue->read(), found = batch->read(nth);
            drop_shared_nans(expected, found);
            require_equal(expected, found);
        }
    }
}

TEST_CASE("batch: fields, mappings, births and counts are each lattice's own") {
    const std::string text =
        "define chemical U\ndefine chemical V\ndefine field spots blobs 9 sigma 2\ndefine field noise (RANDOM)\n"
        "use chemical U conc 1 dev 0.5 diff 0.1\nuse chemical V conc 1\ncreate matrix 33 18\n"
        "rule always map U conc 0 2 to M 0 1\nrule if M > 0.4 change V conc 0.125\n"
        "rule always react V by (spots - noise * V)\nrule if AGE > 5 change V conc 0.25\n"
        "rule if NEIGHBORS == 5 change V conc 0.5\nstop at 20\n";
    const Path path = GENERATE(Path::step, Path::tiled);
    std::vector<BatchStart> starts;
    for (std::int64_t nth = 0; nth < 4; ++nth) {
        Experiment experiment = parse_experiment(text, "own.pex", "");
        experiment.seed = 50 + nth;
        starts.push_back(start_of(std::move(experiment)));
        Snapshot& state = starts.back().state;
        state.iteration = 3;
        for (std::size_t cell = 0; cell < state.cells(); ++cell) {
            state.birth[cell] = static_cast<std::uint32_t>((cell + static_cast<std::size_t>(nth)) % 4);
            state.neighbours[cell] = static_cast<std::int32_t>((cell + 2 * static_cast<std::size_t>(nth)) % 9);
        }
    }
    const auto batch = opencl_backend(by(path))->make_batch(starts);
    std::vector<std::unique_ptr<Tissue>> alone;
    for (const BatchStart& start : starts)
        alone.push_back(reference_backend(Precision::single_)->make_tissue(*start.experiment, start.state));
    for (const std::uint64_t part : {1u, 1u, 9u}) {
        batch->advance(part);
        for (std::size_t nth = 0; nth < starts.size(); ++nth) {
            INFO("lattice " << nth);
            alone[nth]->advance(part);
            require_equal(alone[nth]->read(), batch->read(nth));
        }
    }
}

TEST_CASE("batch: NaNs of one lattice stay its own") {
    std::vector<BatchStart> starts;
    for (std::size_t nth = 0; nth < 3; ++nth) starts.push_back(start_of(busy(20, 20, Boundary::wrap)));
    for (double& value : starts[1].state.conc[0]) value = std::numeric_limits<double>::quiet_NaN();
    const Snapshot expected = run(*reference_backend(Precision::single_), *starts[0].experiment, {12});
    for (const Path path : {Path::step, Path::tiled}) {
        const auto batch = opencl_backend(by(path))->make_batch(starts);
        batch->advance(12);
        require_equal(expected, batch->read(0));
        require_equal(expected, batch->read(2));
        CHECK(std::isnan(batch->read(1).conc[0][7]));
    }
}

TEST_CASE("batch: structure is all but numbers, seed and state") {
    const auto structure = [](const Experiment& experiment) {
        return structure_of(experiment, initial_state(experiment), Precision::single_);
    };
    const Experiment plain = restless(0, Boundary::wrap);
    const std::string one = structure(plain);
    REQUIRE_FALSE(one.empty());
    CHECK(structure(restless(3, Boundary::wrap)) == one);
    CHECK(structure(restless(0, Boundary::no_flux)) != one);
    CHECK(structure(busy(43, 29, Boundary::wrap)) != one);

    const auto changed = [&](const auto& change) {
        Experiment other = plain;
        change(other);
        return structure(other);
    };
    CHECK(changed([](Experiment& other) { other.phases.back().begin = 10; }) != one);
    CHECK(changed([](Experiment& other) { other.phases.back().rates[0].reset(); }) != one);
    CHECK(changed([](Experiment& other) { other.rules.back().every = 2; }) != one);
    CHECK(changed([](Experiment& other) { other.rules.back().from = 3; }) != one);
    CHECK(changed([](Experiment& other) { other.stencil = Stencil::moore; }) != one);
    CHECK(changed([](Experiment& other) { std::get<Change>(other.rules[1].action).deviation = 0.0; }) != one);
    CHECK(changed([](Experiment& other) { std::get<Change>(other.rules[1].action).deviation = 0.25; }) == one);
    CHECK(changed([](Experiment& other) { other.seed = 77; }) == one);

    Lab growing = Lab::matrix(12, 12, Boundary::wrap);
    growing.chemical("U", {1, 1}, {1, 0});
    growing.rule(Expand{1, 1, true, Distribution::uniform, 1.0, 0.0, 0.0, true});
    CHECK(structure(growing.done()).empty());
    Lab volume = Lab::volume(6, 6, 6, Boundary::wrap);
    volume.chemical("U", {1, 1}, {1, 0});
    CHECK(structure(volume.done()).empty());
}

TEST_CASE("batch: what is no batch is refused, and a batch says how it runs") {
    const auto device = opencl_backend(by(Path::tiled));
    const auto one = start_of(busy(16, 16, Boundary::wrap));
    CHECK_THROWS_WITH(device->make_batch({}), Contains("at least one lattice"));
    CHECK_THROWS_WITH(device->make_batch({one, start_of(busy(17, 16, Boundary::wrap))}),
                      Contains("differ in numbers, seed and state alone"));
    const auto batch = device->make_batch({one, one, one});
    batch->advance(2);
    REQUIRE(batch->report().size() == 1);
    CHECK_THAT(batch->report().front(), Contains("3 lattices tiled") && Contains("several lattices a launch"));
}

TEST_CASE("batch: there is room for as many as one buffer and half of the memory hold") {
    const BatchStart one = start_of(busy(48, 31, Boundary::wrap));  // a plane of 64 x 32 numbers, three chemicals
    DeviceInfo device;
    device.memory = std::uint64_t{1} << 40;
    device.max_allocation = 10 * 3 * 64 * 32 * 4 + 10 * 3 + 100;
    const auto room = [&] { return batch_room(device, *one.experiment, one.state, Precision::single_); };
    CHECK(room() == 10);
    device.max_allocation = 3 * 64 * 32 * 4 - 1;
    CHECK(room() == 0);
    device.max_allocation = std::uint64_t{1} << 39;
    device.memory = 100 * 3 * 64 * 32 * 4;
    CHECK(room() < 50);
    CHECK(room() > 10);
}
