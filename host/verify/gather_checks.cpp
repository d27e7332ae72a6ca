// See check.hpp: exchange between neighbours given as compressed rows, on lattices and in spaces without any order.
#include "core/adjacency.hpp"
#include "core/prepattern.hpp"
#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/neighbours/gather.hpp"
#include "reference/backend.hpp"
#include "reference/neighbours/gather.hpp"
#include "verify/bounded.hpp"
#include "verify/cases.hpp"
#include "verify/check.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

#include <array>
#include <random>

namespace pelage::verify {

namespace {

constexpr double dt = 0.02;

struct Amounts {
    std::vector<float> rates, old;
};

std::vector<float> as_float(const std::vector<double>& values) { return {values.begin(), values.end()}; }

// old + what the device gathers.
std::vector<float> on_device(const Session& on, const Adjacency& adjacency, Arithmetic arithmetic,
                             const Amounts& amounts) {
    return with_device(on.info().name, [&] {
        Gather gather(on, adjacency, arithmetic);
        const std::size_t bytes = amounts.old.size() * sizeof(float);
        const auto filled = [&](const std::vector<float>& values, const char* what) {
            cl::Buffer buffer = on.buffer(bytes, what);
            on.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, values.data());
            return buffer;
        };
        const cl::Buffer next = filled(amounts.old, "new amounts");
        gather.run(filled(amounts.rates, "rates"), filled(amounts.old, "amounts"), next, dt);
        std::vector<float> found(amounts.old.size());
        on.queue().enqueueReadBuffer(next, CL_TRUE, 0, bytes, found.data());
        return found;
    });
}

std::vector<float> by_reference(const Adjacency& adjacency, Arithmetic arithmetic, const Amounts& amounts) {
    const SubnormalsAreZero scope;
    std::vector<float> next = amounts.old;
    reference::gather(adjacency, arithmetic, amounts.rates, in_precision<float>(dt), amounts.old, next);
    return next;
}

// One iteration of nothing but exchange: by the backends' own kernels for lattices, and gathered.
Outcome on_lattice(Place& place, Lab lab, double deviation) {
    lab.chemical("U", {5, 3}, {1, deviation}, unbounded);
    const Experiment experiment = lab.time_step(dt).done();
    const Snapshot start = initial_state(experiment);
    const auto lattice = std::get<Lattice>(space_of(experiment));
    const Adjacency adjacency = lattice_adjacency(lattice);
    const Amounts amounts{as_float(start.diff[0]), as_float(start.conc[0])};
    const auto after = [&](Backend& backend) {
        const auto tissue = backend.make_tissue(experiment, start);
        tissue->advance(1);
        return as_float(tissue->read().conc[0]);
    };
    const std::vector<float> special = after(*reference_backend(Precision::single_));
    const std::vector<float> gathered = on_device(place.session(), adjacency, lattice.arithmetic, amounts);
    Outcome outcome;
    add(outcome.tally, special, by_reference(adjacency, lattice.arithmetic, amounts), "gathered by the reference");
    add(outcome.tally, special, gathered, "gathered by the device");
    add(outcome.tally, after(place.backend({})), gathered, "the device's lattice and what it gathers");
    if (special == amounts.old) outcome.tally.first = "nothing was exchanged";
    conclude(outcome);
    return outcome;
}

// Cells with 0 to 12 neighbours each and one with hundreds, whoever they may be; some look beyond an edge.
Adjacency tangle(std::size_t cells, std::mt19937_64& engine) {
    Adjacency made;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const std::size_t count = cell == cells / 2 ? 300 : engine() % 13;
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t whom = engine() % (cells + cells / 10);
            made.indices.push_back(whom < cells ? static_cast<std::uint32_t>(whom) : Adjacency::nobody);
            made.weights.push_back(static_cast<double>(engine() % 1000) / 1000);
        }
        made.offsets.push_back(made.indices.size());
    }
    return made;
}

Outcome without_order(Place& place, std::uint64_t seed) {
    Outcome outcome;
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<float> amount(0, 10);
    constexpr std::size_t beyond_16_bits = 66'001;
    for (const std::size_t cells :
         {std::size_t{1}, std::size_t{2}, std::size_t{63}, std::size_t{65}, std::size_t{1021}, beyond_16_bits}) {
        if (place.small() && cells == beyond_16_bits) continue;
        const Adjacency adjacency = tangle(cells, engine);
        Amounts amounts;
        for (std::size_t cell = 0; cell < cells; ++cell) {
            amounts.rates.push_back(engine() % 5 == 0 ? 0 : amount(engine));
            amounts.old.push_back(amount(engine));
        }
        for (const Arithmetic arithmetic : {Arithmetic::fused, Arithmetic::published}) {
            add(outcome.tally, by_reference(adjacency, arithmetic, amounts),
                on_device(place.session(), adjacency, arithmetic, amounts), fmt::format("{} cells", cells));
        }
    }
    if (!rounds_exactly(place, {}) && within_bound(outcome.tally)) {
        outcome.message = bound_message();
        return outcome;
    }
    conclude(outcome);
    return outcome;
}

}  // namespace

std::vector<Check> gather_checks(std::uint64_t seed) {
    std::vector<Check> checks{
        {"gather/without-order", "gather", true, [=](Place& p) { return without_order(p, seed); }}};
    const auto add = [&](const std::string& name, bool quick, const Lab& lab, double deviation) {
        checks.push_back(
            {"gather/" + name, "gather", quick, [=](Place& place) { return on_lattice(place, lab, deviation); }});
    };
    for (const Boundary boundary : {Boundary::no_flux, Boundary::wrap, Boundary::absorbing}) {
        for (const Stencil stencil : {Stencil::nine_point, Stencil::sims, Stencil::moore, Stencil::five_point}) {
            const bool quick = stencil == Stencil::nine_point && boundary == Boundary::absorbing;
            add(fmt::format("{}/{}", word(stencil), word(boundary)), quick, Lab::matrix(23, 17, boundary, stencil),
                0.5);
        }
    }
    for (const bool wrap : {false, true}) {
        const char* edge = wrap ? "wrap" : "open";
        add(fmt::format("published/{}", edge), !wrap, Lab::grid(23, 17, wrap), 0);
        add(fmt::format("published-uneven/{}", edge), false, Lab::grid(23, 17, wrap), 0.5);
    }
    return checks;
}

}  // namespace pelage::verify
