// See means.hpp.
#include "opencl/lattice/means.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"
#include "opencl/lattice/choice.hpp"
#include "opencl/lattice/emit_lattice.hpp"
#include "opencl/lattice/traits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

namespace {

constexpr std::size_t means_a_cell = 4;

std::string means_source(const Experiment& experiment, const LatticePlan& plan, std::size_t width) {
    const RuleUse none;
    const LatticeTraits traits(experiment, plan, none);
    const std::vector<std::size_t> places = rate_planes(plan);
    std::string planes, means;
    if (traits.polarity()) {
        planes +=
            "global const scalar* const old_px = PLANE(polarity, 0);\n"
            "global const scalar* const old_py = PLANE(polarity, 1);\n"
            "const real px = LOAD(old_px + at);\nconst real py = LOAD(old_py + at);\n";
    }
    for (std::size_t i = 0; i < plan.rates.size(); ++i) {
        if (!traits.per_cell(i)) continue;
        planes += fmt::format(
            "global const scalar* const d{0} = PLANE(rates, {1});\nconst real r{0} = LOAD(d{0} + at);\n"
            "global scalar* const means{0} = PLANE(means, {2});\n",
            i, places[i], means_a_cell * places[i]);
        const bool directed = traits.directed(i);
        const std::string own =
            directed ? fmt::format("pelage_directed(r{}, px, py, dx, dy, diagonal)", i) : fmt::format("r{}", i);
        const std::string theirs =
            directed ? fmt::format("pelage_directed(THEIRS(d{}), THEIRS(old_px), THEIRS(old_py), dx, dy, diagonal)", i)
                     : fmt::format("THEIRS(d{})", i);
        means += fmt::format("STORE(SELECT(held, pelage_shared_rate({1}, {2}), R(0)), means{0} + k * plane + at);\n", i,
                             own, theirs);
    }
    Source source;
    source.text(lattice_settings(plan, width));
    source.file("common/prelude.cl").file("lattice/rows.cl").file("common/exchange.cl").file("lattice/exchange.cl");
    return source.file("lattice/means.cl", {{"planes", planes}, {"means", means}}).str();
}

}  // namespace

bool means_pay(const Session& session, const LatticePlan& plan, const RuleUse& every) {
    return session.info().processor() && plan.reach() == 1 && !plan.volume() && own_rates(plan) > 0 &&
           every.rates_written.empty() && every.polarizes.empty();
}

LatticeMeans::LatticeMeans(const Session& session, const Experiment& experiment, const LatticePlan& plan)
    : session_(session),
      kernel_(session.build(means_source(experiment, plan, lattice_width(session.info(), session.options()))),
              "pelage_lattice_means"),
      width_(lattice_width(session.info(), session.options())),
      planes_(session, "mean diffusion rates", means_a_cell * own_rates(plan), false) {}

const cl::Buffer& LatticeMeans::of(LatticeState& state) {
    if (version_ == state.rates_version()) return planes_.now();
    const Grid& grid = state.grid();
    planes_.resize(grid);
    Arguments(session_, kernel_)
        .add(state.rates().now(), state.polarity().now(), planes_.now(), grid.columns, grid.rows, grid.pitch());
    const std::size_t items = std::min<std::size_t>(grid.rows, 4 * session_.info().compute_units);
    session_.launch(kernel_, cl::NDRange(1, items), cl::NDRange(1, 1));
    version_ = state.rates_version();
    return planes_.now();
}

}  // namespace pelage
