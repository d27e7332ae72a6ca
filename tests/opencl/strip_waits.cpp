// Work-groups that share a lattice's steps, in all orders of their moves in small cases, and in many of larger ones.
// Nobody may read what is not written, or overwrite what is still read, and all come to an end.
#include "opencl/strip_model.hpp"

#include <catch2/catch.hpp>

#include <random>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

using namespace test;

namespace {

// Whether the group comes to its end if nobody else gets a processor any more, and does the strips of who never came.
bool alone_to_the_end(const StripCase& one, State state, std::size_t which) {
    for (int moves = 0; moves < 4000; ++moves) {
        const bool all_here = state.arrived == static_cast<int>(groups_of(one));
        if (state.groups[which].phase == Group::gone) return all_here || all_done(one, state);
        if (!move(one, state, which).empty()) return false;
    }
    return false;
}

struct Findings {
    std::size_t states = 0;
    std::string fault;  // the first one
};

Findings explore(const StripCase& one) {
    std::unordered_set<std::string> known;
    std::vector<State> open{first_strip_state(one)};
    known.insert(text_of(open.back()));
    while (!open.empty()) {
        const State state = std::move(open.back());
        open.pop_back();
        bool any = false;
        for (std::size_t which = 0; which < groups_of(one); ++which) {
            if (state.groups[which].phase == Group::gone) continue;
            any = true;
            State next = state;
            const std::string fault = move(one, next, which);
            if (!fault.empty()) return {known.size(), fault};
            if (known.insert(text_of(next)).second) open.push_back(std::move(next));
        }
        if (!any && !all_done(one, state)) return {known.size(), "all have gone and not all is done"};
        if (state.claimed != state.done || known.size() % 16 != 0) continue;  // who holds a strip must go on
        for (std::size_t which = 0; which < groups_of(one); ++which) {
            if (state.groups[which].phase != Group::gone && !alone_to_the_end(one, state, which))
                return {known.size(), "a group that others leave alone does not end"};
        }
    }
    return {known.size(), ""};
}

// One order of moves, drawn: a group makes some moves, then another one does.
std::string fault_of_walk(const StripCase& one, std::mt19937& dice) {
    State state = first_strip_state(one);
    std::size_t turns = 0;
    for (std::size_t left = groups_of(one); left > 0;) {
        if (++turns == 20'000) return "there is no end";
        const std::size_t which = dice() % groups_of(one);
        for (std::size_t moves = 1 + dice() % (1u << dice() % 7); moves > 0; --moves) {
            if (state.groups[which].phase == Group::gone) break;
            const std::string fault = move(one, state, which);
            if (!fault.empty()) return fault;
            if (state.groups[which].phase == Group::gone) --left;
        }
    }
    return all_done(one, state) ? "" : "all have gone and not all is done";
}

}  // namespace

TEST_CASE("two groups that share steps wait for each other in every order of their moves") {
    const StripCase one = GENERATE(StripCase{2, 0, 2}, StripCase{2, 3, 6});
    CAPTURE(one.begin, one.end);
    const Findings found = explore(one);
    CHECK(found.fault == "");
    CHECK(found.states > 10'000);
}

TEST_CASE("several groups that share steps wait for each other in many orders of their moves") {
    const StripCase one = GENERATE(StripCase{3, 0, 3}, StripCase{4, 7, 10});
    CAPTURE(one.strips);
    std::mt19937 dice(1);
    for (int walk = 0; walk < 600; ++walk) {
        CAPTURE(walk);
        REQUIRE(fault_of_walk(one, dice) == "");
    }
}

TEST_CASE("without fences nobody knows what others wrote, and that is seen") {
    CHECK(explore({2, 0, 3, false}).fault == "reads what is not written");
}
