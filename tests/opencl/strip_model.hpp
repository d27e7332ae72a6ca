// A model of work-groups that share a lattice's steps: the functions of kernels/lattice/together.cl, compiled for the
// host. Each access to memory that groups share is one move.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace test {

constexpr std::size_t most_strips = 4;

// Both buffers of each strip: the level whose values they hold.
using Versions = std::array<std::array<int, 2>, most_strips>;

struct Group {
    enum Phase { away, claiming, working, finishing, gone };
    Phase phase = away;
    std::vector<int> heard{};  // what the accesses of the call that it is in gave
    std::size_t rounds = 0;    // of its search for a strip, that are over
    std::size_t round = 0;     // where in `heard` the present one begins
    int strip = 0, level = 0;
    Versions seen{};  // as of its last fence
};

struct State {
    int arrived = 0;
    std::array<int, most_strips> claimed{}, done{};
    Versions written{};  // and known to whoever looks
    std::vector<Group> groups;
};

struct StripCase {
    int strips, begin, end;
    bool fences = true;
};

inline std::size_t groups_of(const StripCase& one) { return static_cast<std::size_t>(one.strips); }

State first_strip_state(const StripCase&);

// The group's next move. What is wrong then; empty: nothing.
std::string move(const StripCase&, State&, std::size_t group);

bool all_done(const StripCase&, const State&);

// States with one text go on alike.
std::string text_of(const State&);

}  // namespace test
