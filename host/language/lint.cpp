// See lint.hpp: the table of lints, and what they share.
#include "language/lint.hpp"

#include "language/include.hpp"
#include "language/lints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace pelage {

namespace language {

namespace {

struct Entry {
    std::string_view name;
    Lint find;
};

constexpr std::array lints{Entry{"idle-rule", find_idle_rules},
                           Entry{"impossible", find_impossible_conditions},
                           Entry{"dangling-and", find_dangling_and},
                           Entry{"idle-phase", find_idle_phases},
                           Entry{"late-snapshot", find_late_snapshots},
                           Entry{"repeated", find_repeated_settings},
                           Entry{"unstable", find_unstable_steps},
                           Entry{"backwards", find_backward_networks},
                           Entry{"late-use", find_late_uses},
                           Entry{"outside", find_cells_outside},
                           Entry{"odd-start", find_odd_starts},
                           Entry{"no-shape", find_shapes_that_are_none},
                           Entry{"mended-mesh", find_mended_meshes},
                           Entry{"unused-chemical", find_unused_chemicals},
                           Entry{"unused-mapping", find_unused_mappings},
                           Entry{"unused-colour", find_unused_colours},
                           Entry{"equal-outputs", find_equal_outputs},
                           Entry{"unused-parameter", find_unused_parameters},
                           Entry{"unused-field", find_unused_fields},
                           Entry{"unused-stencil", find_unused_stencils}};

}  // namespace

Sheet::Sheet(const Experiment& experiment_, const Outline& outline_, std::uint64_t last_)
    : experiment(experiment_), outline(outline_), last(last_), lines_(lines_of(experiment_.text)) {}

Cursor Sheet::read(std::size_t line) const {
    return {experiment.where(line), line, lines_[line - 1], experiment.parameters};
}

Place Sheet::place(std::size_t line, std::string_view word) const {
    Cursor words = read(line);
    const Place first = words.place(words.peek());
    while (!words.done()) {
        const Token& token = words.next();
        if (token.text == word) return words.place(token);
    }
    return first;
}

}  // namespace language

std::vector<Warning> lint(const Experiment& experiment, const Outline& outline, std::uint64_t last) {
    const language::Sheet sheet(experiment, outline, last);
    std::vector<Warning> warnings;
    for (const language::Entry& entry : language::lints) {
        language::Reporter report(entry.name, warnings);
        entry.find(sheet, report);
    }
    std::ranges::stable_sort(warnings, {}, [](const Warning& one) { return std::tuple(one.line, one.column); });
    return warnings;
}

std::string shown(const Experiment& experiment, const Warning& warning) {
    return fmt::format("{}:{}: warning: {} [{}]", experiment.where(warning.line), warning.column, warning.text,
                       warning.lint);
}

}  // namespace pelage
