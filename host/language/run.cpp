// phase, snap, stop: the course of a run.
#include "language/parse.hpp"
#include "language/statements.hpp"

#include <fmt/format.h>

#include <array>

namespace pelage::language {

namespace {

void check_snapshots(const Script& script, const Cursor& cursor, const Token& at, std::uint64_t more) {
    if (more > largest_snapshot_count - script.experiment.snap_at.size()) {
        cursor.fail(at, fmt::format("too many snapshots; at most {} are allowed", largest_snapshot_count));
    }
}

void snap_at(Script& script, Cursor& cursor) {
    do {
        const Token& token = cursor.peek();
        const std::uint64_t iteration = cursor.integer("the snapshot's iteration", 0, largest_iteration);
        check_snapshots(script, cursor, token, 1);
        script.experiment.snap_at.push_back(iteration);
    } while (!cursor.done() && cursor.peek().text != "then");
}

void snap_from(Script& script, Cursor& cursor) {
    const std::uint64_t first = cursor.integer("the first snapshot's iteration", 0, largest_iteration);
    cursor.expect("repeat");
    const Token& repeat = cursor.peek();
    const std::uint64_t count = cursor.integer("the number of snapshots", 1, largest_snapshot_count);
    check_snapshots(script, cursor, repeat, count);
    cursor.expect("step");
    const Token& last = cursor.peek();
    const std::uint64_t step = cursor.integer("the step", 1, largest_iteration);
    if (first + (count - 1) * step > largest_iteration) {
        cursor.fail(last, fmt::format("the last snapshot would come at iteration {}; runs end at {} at the latest",
                                      first + (count - 1) * step, largest_iteration));
    }
    for (std::uint64_t i = 0; i < count; ++i) script.experiment.snap_at.push_back(first + i * step);
}

}  // namespace

void parse_phase(Script& script, Cursor& cursor) {
    const Token& name = cursor.text("the phase's name");
    if (script.experiment.phases.size() == largest_phase_count) {
        cursor.fail(name, fmt::format("one phase too many; at most {} are allowed", largest_phase_count));
    }
    const std::uint64_t begin = script.in_phase() ? script.phase_end() : 0;
    const Token& steps = cursor.peek();
    const std::uint64_t count = cursor.integer("the number of iterations", 1, largest_iteration);
    if (begin + count > largest_iteration) {
        cursor.fail(steps, fmt::format("the phase would end at iteration {}; runs end at {} at the latest",
                                       begin + count, largest_iteration));
    }
    script.begin_phase(std::string(name.text), count);
}

void parse_snap(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 2> words{"at", "from"};
    if (cursor.choose(words) == 0)
        snap_at(script, cursor);
    else
        snap_from(script, cursor);
    if (cursor.take("then")) {
        cursor.expect("exit");
        script.experiment.exit_after_snaps = true;
    }
}

void parse_stop(Script& script, Cursor& cursor) {
    cursor.expect("at");
    script.stop = cursor.integer("the last iteration", 0, largest_iteration);
}

}  // namespace pelage::language
