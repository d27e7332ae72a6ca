// See strip_model.hpp.
#include "opencl/strip_model.hpp"

#include <algorithm>
#include <utility>

namespace test {

namespace {

struct Moved {};  // thrown where a group would make its second move

// The world of the call that is followed now.
struct Stage {
    State* state = nullptr;
    Group* group = nullptr;
    const StripCase* chosen = nullptr;
    std::size_t place = 0;  // in what the group has heard
    bool moved = false;

    template <class Access>
    int access(const Access& perform) {
        if (place < group->heard.size()) return group->heard[place++];
        if (moved) throw Moved{};
        moved = true;
        const int value = perform();
        group->heard.push_back(value);
        ++place;
        return value;
    }
};

Stage stage;

int& flag(int place) {
    State& state = *stage.state;
    if (place == 0) return state.arrived;
    const auto nth = static_cast<std::size_t>(place / 32 - 1);
    return nth % 2 == 0 ? state.claimed[nth / 2] : state.done[nth / 2];
}

// A number of `flags`, which knows its place there. To copy it is to read it, once.
struct Shared {
    int value = 0;
    bool copied = false;
    Shared() = default;
    Shared(const Shared& other) : value(other), copied(true) {}
    Shared& operator=(const Shared&) = delete;
    operator int() const;
};

constexpr std::size_t patience = 1;

// A search begins a round by asking who has arrived. All rounds after the patient ones are alike: one is kept.
void begin_round(Group& group) {
    if (group.rounds > patience) {
        group.heard.resize(group.round);
    } else if (!group.heard.empty()) {
        ++group.rounds;
    }
    group.round = group.heard.size();
    stage.place = group.heard.size();
}

Shared::operator int() const {
    if (copied) return value;
    const bool new_round = value == 0 && stage.place == stage.group->heard.size() && !stage.moved;
    if (new_round) begin_round(*stage.group);
    return stage.access([&] { return flag(value); });
}

int atomic_cmpxchg(Shared* place, int expected, int wanted) {
    return stage.access([&] {
        int& shared = flag(place->value);
        const int before = shared;
        if (before == expected) shared = wanted;
        return before;
    });
}

int atomic_xchg(Shared* place, int wanted) {
    return stage.access([&] { return std::exchange(flag(place->value), wanted); });
}

// What the group wrote is known from now on, and it knows what the others wrote.
void mem_fence(int) {
    stage.access([] {
        if (!stage.chosen->fences) return 0;
        Group& group = *stage.group;
        if (group.phase == Group::finishing) {
            const auto strip = static_cast<std::size_t>(group.strip);
            const auto buffer = static_cast<std::size_t>(group.level + 1) % 2;
            stage.state->written[strip][buffer] = group.seen[strip][buffer];
        }
        group.seen = stage.state->written;
        return 0;
    });
}

#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wkeyword-macro"
#endif
#define PATIENCE 1  // as `patience`
#define CLK_GLOBAL_MEM_FENCE 0
#define volatile
#define global
#define int auto  // flags are of another type here
#include "kernels/lattice/together.cl"
#undef int
#undef global
#undef volatile
#ifdef __clang__
#pragma clang diagnostic pop
#endif

Shared* shared_flags() {
    static std::array<Shared, CLAIMED(most_strips)> flags;
    for (std::size_t i = 0; i < flags.size(); ++i) flags[i].value = static_cast<int>(i);
    return flags.data();
}

std::array<std::size_t, 3> read_by(const StripCase& one, const Group& group) {
    const int strip = group.strip, last = one.strips - 1;
    const int below = strip > 0 ? strip - 1 : last, above = strip < last ? strip + 1 : 0;
    return {static_cast<std::size_t>(strip), static_cast<std::size_t>(below), static_cast<std::size_t>(above)};
}

bool disturbs(const StripCase& one, const Group& writer, const Group& other) {
    const auto strip = static_cast<std::size_t>(writer.strip);
    const int buffer = (writer.level + 1) % 2;
    const auto read = read_by(one, other);
    const bool reads = other.level % 2 == buffer && std::ranges::find(read, strip) != read.end();
    return reads || (other.strip == writer.strip && (other.level + 1) % 2 == buffer);
}

// What is wrong where a group begins a level; empty: nothing.
std::string fault_of(const StripCase& one, const State& state, const Group& group) {
    for (const std::size_t strip : read_by(one, group)) {
        if (group.seen[strip][static_cast<std::size_t>(group.level) % 2] != group.level)
            return "reads what is not written";
    }
    for (const Group& other : state.groups) {
        if (&other == &group || other.phase != Group::working) continue;
        if (disturbs(one, group, other) || disturbs(one, other, group)) return "two groups disturb each other";
    }
    return "";
}

void begin_call(Group& group, Group::Phase phase) {
    group.phase = phase;
    group.heard.clear();
    group.rounds = group.round = 0;
}

}  // namespace

std::string move(const StripCase& one, State& state, std::size_t which) {
    Group& group = state.groups[which];
    stage = {&state, &group, &one, 0, false};
    if (group.phase == Group::away) {
        ++state.arrived;
        begin_call(group, Group::claiming);
        return "";
    }
    if (group.phase == Group::working) {
        group.seen[static_cast<std::size_t>(group.strip)][static_cast<std::size_t>(group.level + 1) % 2] =
            group.level + 1;
        begin_call(group, Group::finishing);
        return "";
    }
    static Shared* const flags = shared_flags();
    try {
        if (group.phase == Group::finishing) {
            pelage_done(flags, group.strip, group.level);
            begin_call(group, Group::claiming);
            return "";
        }
        int level = 0;
        const int strip = pelage_claim(flags, one.strips, static_cast<int>(which) % one.strips, one.end,
                                       static_cast<int>(groups_of(one)), &level);
        begin_call(group, strip < 0 ? Group::gone : Group::working);
        group.strip = strip;
        group.level = level;
        return strip < 0 ? "" : fault_of(one, state, group);
    } catch (const Moved&) {
        return "";
    }
}

std::string text_of(const State& state) {
    std::string text;
    const auto add = [&](int number) { text += static_cast<char>(number + 1); };
    add(state.arrived);
    for (std::size_t i = 0; i < most_strips; ++i) {
        for (const int number : {state.claimed[i], state.done[i], state.written[i][0], state.written[i][1]})
            add(number);
    }
    for (const Group& group : state.groups) {
        for (const int number :
             {static_cast<int>(group.phase), static_cast<int>(group.rounds), group.strip, group.level})
            add(number);
        for (const auto& strip : group.seen) {
            for (const int number : strip) add(number);
        }
        for (std::size_t i = group.round; i < group.heard.size(); ++i) add(group.heard[i]);
        text += '\0';
    }
    return text;
}

State first_strip_state(const StripCase& one) {
    State state;
    for (std::size_t i = 0; i < most_strips; ++i) {
        state.claimed[i] = state.done[i] = one.begin;
        state.written[i][static_cast<std::size_t>(one.begin) % 2] = one.begin;
        state.written[i][static_cast<std::size_t>(one.begin + 1) % 2] = one.begin - 1;
    }
    state.groups.resize(groups_of(one));
    for (Group& group : state.groups) {
        group.seen = state.written;
    }
    return state;
}

bool all_done(const StripCase& one, const State& state) {
    return std::all_of(state.done.begin(), state.done.begin() + one.strips,
                       [&](int level) { return level == one.end; });
}

}  // namespace test

#undef PATIENCE
#undef CLK_GLOBAL_MEM_FENCE
#undef ARRIVED
#undef CLAIMED
#undef DONE
