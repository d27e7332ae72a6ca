// See bounded.hpp.
#include "verify/bounded.hpp"

#include "reference/backend.hpp"

#include <fmt/format.h>

namespace pelage::verify {

bool rounds_exactly(const Place& place, const Setting& setting) {
    return setting.precision == Precision::double_ || place.device().correctly_rounded_divide_sqrt;
}

bool within_bound(const Tally& tally) { return tally.same_structure && tally.max_scaled <= division_bound; }

std::string bound_message() {
    return fmt::format("within {} after one iteration: the device need not round division correctly", division_bound);
}

Tally single_iterations(const Experiment& experiment, const std::vector<Snapshot>& states, Place& place,
                        const Setting& setting) {
    Tally tally;
    const auto reference = reference_backend(setting.precision, setting.search);
    for (const Snapshot& state : states) {
        const auto expected = reference->make_tissue(experiment, state);
        const auto found = place.backend(setting).make_tissue(experiment, state);
        expected->advance(1);
        found->advance(1);
        add(tally, expected->read(), found->read(), setting.precision,
            fmt::format("one iteration from iteration {}", state.iteration));
    }
    return tally;
}

void conclude_bounded(Outcome& outcome, const Experiment& experiment, const std::vector<Snapshot>& states, Place& place,
                      const Setting& setting) {
    if (outcome.tally.equal()) return;
    if (!rounds_exactly(place, setting)) {
        outcome.tally = single_iterations(experiment, states, place, setting);
        outcome.message = bound_message();
        if (within_bound(outcome.tally)) return;
    }
    outcome.verdict = Verdict::failed;
}

}  // namespace pelage::verify
