// See lattice_support.hpp.
#include "lattice_support.hpp"

#include "core/prepattern.hpp"
#include "reference/backend.hpp"
#include "support/shared.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace test {

using namespace pelage;

NpyArray golden(const std::string& relative) { return read_npy(shared("golden/" + relative + ".npy")); }

Difference difference(const std::vector<double>& found, const std::vector<double>& golden) {
    if (found.size() != golden.size() || golden.empty()) throw std::runtime_error("nothing to compare with");
    Difference result;
    const auto [low, high] = std::minmax_element(golden.begin(), golden.end());
    result.range = *high - *low;
    result.magnitude = std::max(std::abs(*low), std::abs(*high));
    for (std::size_t i = 0; i < golden.size(); ++i) {
        if (found[i] == golden[i]) continue;
        ++result.unequal;
        const double off = std::abs(found[i] - golden[i]);
        result.largest = std::isfinite(off) ? std::max(result.largest, off) : std::numeric_limits<double>::infinity();
    }
    return result;
}

Experiment matrix(std::size_t columns, std::size_t rows, Boundary boundary, Stencil stencil, double time_step,
                  const std::vector<Substance>& substances) {
    Experiment experiment;
    experiment.stencil = stencil;
    Phase phase;
    phase.time_step = time_step;
    for (const Substance& substance : substances) {
        const std::size_t index = experiment.chemicals.size();
        experiment.chemicals.push_back({substance.name, substance.bounds, false, nullptr});
        experiment.prepattern.push_back(UseChemical{index, std::nullopt, Spread{substance.rate, 0.0}});
        phase.bounds.push_back(substance.bounds);
        phase.rates.push_back(std::nullopt);
    }
    experiment.prepattern.push_back(CreateMatrix{columns, rows, boundary, 0.0, 0.0});
    experiment.phases.push_back(phase);
    experiment.outputs.push_back({});
    return experiment;
}

Rule always(Action action) {
    Rule rule;
    rule.action = std::move(action);
    return rule;
}

std::unique_ptr<Tissue> start(const Experiment& experiment, const std::vector<NpyArray>& concentrations,
                              Precision precision) {
    Snapshot initial = initial_state(experiment);
    for (std::size_t chemical = 0; chemical < concentrations.size(); ++chemical) {
        const NpyArray& array = concentrations[chemical];
        if (array.shape != std::vector<std::size_t>{initial.rows, initial.columns}) {
            throw std::runtime_error("a golden array is not of the experiment's shape");
        }
        initial.conc.at(chemical) = array.values;
    }
    for (const Statement& statement : experiment.prepattern) {  // not rounded to float, as the prepattern does it
        const auto* use = std::get_if<UseChemical>(&statement);
        if (use != nullptr && use->diff) initial.diff.at(use->chemical).assign(initial.cells(), use->diff->value);
    }
    return reference_backend(precision)->make_tissue(experiment, initial);
}

}  // namespace test
