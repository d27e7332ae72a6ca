// What happens between iterations: in which order, and when next.
#include "core/events.hpp"

#include "core/schedule.hpp"
#include "language/parse.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace pelage;

namespace {

Experiment staged() {
    return parse_experiment(
        "define chemical U\nuse chemical U conc 1 diff 0.1\ncreate matrix 10 6\n"
        "rule from 4 until 12 every 4 always expand rows 1 columns 1\n"
        "rule from 8 always change U conc 0.1\n"
        "rule from 8 until 8 always expand rows 2\n"
        "stop at 20\n",
        "events.pex", ".");
}

// "phase" and the places of rules.
std::vector<std::string> names(const Experiment& experiment, std::uint64_t iteration) {
    std::vector<std::string> list;
    for (const Event& event : events_before(experiment, iteration)) {
        const auto* expansion = std::get_if<Expansion>(&event);
        list.push_back(expansion == nullptr ? "phase" : std::to_string(expansion->rule));
    }
    return list;
}

}  // namespace

TEST_CASE("events come in order: the phase, then rules by their place") {
    Experiment experiment = staged();
    experiment.phases.push_back(experiment.phases.front());
    experiment.phases.back().begin = 8;
    using Names = std::vector<std::string>;

    CHECK(names(experiment, 0) == Names{"phase"});
    CHECK(names(experiment, 1).empty());
    CHECK(names(experiment, 4) == Names{"0"});
    CHECK(names(experiment, 8) == Names{"phase", "0", "2"});
    CHECK(std::get<NewPhase>(events_before(experiment, 8).front()).phase == &experiment.phases.back());
}

TEST_CASE("the next event is the next iteration that has any") {
    Experiment experiment = staged();
    experiment.phases.push_back(experiment.phases.front());
    experiment.phases.back().begin = 10;
    for (std::uint64_t iteration = 0; iteration < 30; ++iteration) {
        std::uint64_t brute = iteration + 1;
        while (brute < 100 && events_before(experiment, brute).empty()) ++brute;
        INFO("iteration " << iteration);
        CHECK(next_event(experiment, iteration) == (brute == 100 ? forever : brute));
    }
}

TEST_CASE("rules that are events act in no iteration") {
    const Experiment experiment = staged();

    CHECK(active_rules(experiment, 8) == std::vector<bool>{false, true, false});
    CHECK(next_change(experiment, 0) == 8);
    CHECK(next_change(experiment, 8) == forever);
}
