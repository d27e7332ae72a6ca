// See foresee.hpp.
#include "app/foresee.hpp"

#include "app/machine.hpp"
#include "app/memory.hpp"
#include "app/run_options.hpp"
#include "core/aggregate.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/forecast.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "language/lints.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace pelage::app {

namespace {

constexpr double soon_looked_at = 1'000'000;  // cells
constexpr double on_any_device = 1 << 28;     // bytes; OpenCL devices have more, and none is asked for less

bool computes_start(const Experiment& experiment) {
    return !experiment.fields.empty() || !experiment.expressions.empty() || has_charges(experiment);
}

// The line of the first `create`, with its column.
Warning at_creation(const Experiment& experiment, const Outline& outline, std::string text) {
    const language::Sheet sheet(experiment, outline, experiment.last_iteration());
    const auto found = std::ranges::find_if(
        outline.statements, [](const Outline::Statement& one) { return one.what.starts_with("create"); });
    const std::size_t line = found == outline.statements.end() ? 1 : found->line;
    return {"too-large", line, sheet.place(line).column, std::move(text)};
}

// Why a run would be refused, or would not take the device; empty: it has room.
std::string why_too_large(const Experiment& experiment, const Footprint& need) {
    try {
        check_cells(experiment, need);
        if (need.device <= on_any_device && need.states() + need.reference + compiler_bytes <= usable_memory())
            return {};
        const Machine machine = choose_machine(RunOptions{}, experiment, need);
        check_host_memory(experiment, need, worked(machine), usable_memory());
        return machine.why;
    } catch (const Error& error) {
        const std::string text = error.what(), source = experiment.source + ": ";
        return text.starts_with(source) ? text.substr(source.size()) : text;
    }
}

}  // namespace

void check_start(const Experiment& experiment) {
    if (!computes_start(experiment) || final_cells(experiment, 0) > soon_looked_at) return;
    const Snapshot start = initial_state(experiment);
    if (has_charges(experiment)) (void)front_of(experiment, start);
    if (on_grid(space_of(experiment))) (void)field_values(experiment, extent_of(start), Precision::single_);
}

std::optional<Warning> warn_of_size(const Experiment& experiment, const Outline& outline) {
    const Footprint need = footprint(experiment, experiment.last_iteration(), Precision::single_, false);
    std::string why = why_too_large(experiment, need);
    if (why.empty()) return std::nullopt;
    return at_creation(experiment, outline, std::move(why));
}

}  // namespace pelage::app
