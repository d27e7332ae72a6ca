// What a lint sees, and the lints: each looks for one kind of mistake and reports it where it stands.
#pragma once

#include "language/cursor.hpp"
#include "language/lint.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::language {

class Sheet {
public:
    Sheet(const Experiment& experiment_, const Outline& outline_, std::uint64_t last_);

    const Experiment& experiment;
    const Outline& outline;
    std::uint64_t last;  // the iteration at which the run ends

    Cursor read(std::size_t line) const;  // its words
    // Where `word` stands in the line; its first word where it does not.
    Place place(std::size_t line, std::string_view word = {}) const;

private:
    std::vector<std::string_view> lines_;
};

class Reporter {
public:
    Reporter(std::string_view lint, std::vector<Warning>& warnings) : lint_(lint), warnings_(warnings) {}
    void operator()(Place place, const std::string& text) {
        warnings_.push_back({std::string(lint_), place.line, place.column, text});
    }

private:
    std::string_view lint_;
    std::vector<Warning>& warnings_;
};

using Lint = void (*)(const Sheet&, Reporter&);

// Iteration 0 to the end: lint_course.cpp.
void find_late_snapshots(const Sheet&, Reporter&);
void find_idle_phases(const Sheet&, Reporter&);
void find_repeated_settings(const Sheet&, Reporter&);
void find_unstable_steps(const Sheet&, Reporter&);
void find_backward_networks(const Sheet&, Reporter&);

// Rules: lint_rules.cpp.
void find_idle_rules(const Sheet&, Reporter&);
void find_impossible_conditions(const Sheet&, Reporter&);
void find_dangling_and(const Sheet&, Reporter&);

// How the tissue starts: lint_start.cpp.
void find_late_uses(const Sheet&, Reporter&);
void find_cells_outside(const Sheet&, Reporter&);
void find_shapes_that_are_none(const Sheet&, Reporter&);
void find_mended_meshes(const Sheet&, Reporter&);
void find_odd_starts(const Sheet&, Reporter&);

// What is described and not needed: lint_unused.cpp.
void find_unused_chemicals(const Sheet&, Reporter&);
void find_unused_mappings(const Sheet&, Reporter&);
void find_unused_fields(const Sheet&, Reporter&);
void find_unused_stencils(const Sheet&, Reporter&);
void find_unused_colours(const Sheet&, Reporter&);
void find_equal_outputs(const Sheet&, Reporter&);
void find_unused_parameters(const Sheet&, Reporter&);

// Which values the condition's operands can have at all between two iterations, when these can never fulfil it; empty
// when they can: interval.cpp.
std::string why_impossible(const Experiment&, const Condition&, std::uint64_t first, std::uint64_t last);

}  // namespace pelage::language
