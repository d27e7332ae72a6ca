// See check.hpp: experiments that nobody chose, made from the seed.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "verify/bounded.hpp"
#include "verify/check.hpp"
#include "verify/random_experiment.hpp"

#include <fmt/format.h>

namespace pelage::verify {

namespace {

constexpr std::size_t quick_count = 2;
constexpr std::size_t full_count = 16;

Outcome follows(Place& place, std::uint64_t seed) {
    Outcome outcome;
    RandomLimits limits;
    limits.extremes = place.subnormal_difference().empty();
    const std::string text = random_experiment(seed, limits);
    const Experiment experiment = parse_experiment(text, fmt::format("random experiment {}", seed), ".");
    const Snapshot initial = initial_state(experiment);
    const auto expected = reference_backend(Precision::single_)->make_tissue(experiment, initial);
    const auto found = place.backend({}).make_tissue(experiment, initial);
    const std::uint64_t last = std::min<std::uint64_t>(experiment.last_iteration(), place.small() ? 4 : 40);
    std::vector<Snapshot> states{initial};
    for (std::uint64_t done = 0; done < last && outcome.tally.equal();) {
        const std::uint64_t count = std::min<std::uint64_t>(1 + done, last - done);
        expected->advance(count);
        found->advance(count);
        done += count;
        states.push_back(expected->read());
        add(outcome.tally, states.back(), found->read(), Precision::single_, fmt::format("iteration {}", done));
    }
    if (outcome.tally.equal()) return outcome;
    if (!rounds_exactly(place, {})) {
        const Tally one = single_iterations(experiment, states, place, {});
        if (within_bound(one)) return {Verdict::passed, one, bound_message(), {}};
    }
    outcome.verdict = Verdict::failed;
    outcome.message = "the experiment:\n" + text;
    return outcome;
}

}  // namespace

std::vector<Check> random_checks(std::uint64_t seed) {
    std::vector<Check> checks;
    for (std::size_t i = 0; i < full_count; ++i) {
        const std::uint64_t own = seed * 1'000'003 + i;
        checks.push_back({fmt::format("random-experiment/{}", i), "random experiments", i < quick_count,
                          [=](Place& place) { return follows(place, own); }});
    }
    return checks;
}

}  // namespace pelage::verify
