// When rules act, and how many iterations may share one set of active rules.
#include "core/schedule.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

namespace {

Rule interval(std::uint64_t from, std::uint64_t until) {
    Rule rule;
    rule.from = from;
    rule.until = until;
    return rule;
}

}  // namespace

TEST_CASE("from and until are inclusive") {
    const Rule rule = interval(3, 5);

    CHECK_FALSE(rule.active(2));
    CHECK(rule.active(3));
    CHECK(rule.active(5));
    CHECK_FALSE(rule.active(6));
}

TEST_CASE("every and offset count from the phase's start") {
    Rule rule = interval(100, 220);
    rule.origin = 100;
    rule.every = 50;
    rule.offset = 1;

    CHECK_FALSE(rule.active(51));
    CHECK_FALSE(rule.active(100));
    CHECK(rule.active(101));
    CHECK(rule.active(151));
    CHECK(rule.active(201));
    CHECK_FALSE(rule.active(251));
    CHECK(next_active(rule, 0) == 101);
    CHECK(next_active(rule, 102) == 151);
    CHECK(next_active(rule, 202) == forever);
}

TEST_CASE("next_change is the first iteration with another active set") {
    Experiment experiment;
    experiment.rules = {interval(0, forever), interval(10, 19), interval(0, 14)};
    experiment.rules.push_back(interval(0, 40));
    experiment.rules.back().every = 7;

    for (std::uint64_t iteration = 0; iteration < 60; ++iteration) {
        std::uint64_t brute = iteration + 1;
        while (brute < 200 && active_rules(experiment, brute) == active_rules(experiment, iteration)) ++brute;
        INFO("iteration " << iteration);
        CHECK(next_change(experiment, iteration) == (brute == 200 ? forever : brute));
    }
}
