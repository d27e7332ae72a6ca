// The parameters of one rule as OpenCL C, and the random draws they need.
#pragma once

#include "core/experiment.hpp"
#include "core/space.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace pelage {

// Operands must be asked for in the order in which RANDOM is counted: condition first, then the action's.
class OperandEmitter {
public:
    OperandEmitter(const Experiment& experiment, std::size_t rule, Numbers& numbers)
        : experiment_(experiment), places_(on_grid(space_of(experiment))), rule_(rule), numbers_(numbers) {}

    std::string text(const Operand&);   // of type real
    std::string whole(const Operand&);  // of type uintv; for is_whole() quantities
    // The mask of a comparison that compared_exactly() has exact.
    std::string exactly(const Operand& left, Comparison, const Operand& right);

    // Uniform in [0, 1): first word of this rule's draw for `purpose`.
    std::string draw(std::uint32_t purpose);

    // Declarations of the draws and of the parts of expressions asked for since the last call; to be put before the
    // first use.
    std::string take_declarations();
    bool has_declarations() const { return !pending_.empty(); }
    // Likewise, of what is the same for all cells in an iteration: to be put before the loops over cells.
    std::string take_shared() { return std::exchange(shared_, {}); }

    void note_use(RuleUse&) const;

private:
    void need(std::uint32_t purpose);
    std::string expression(const Expression&);
    std::string around(const NamedStencil&, std::size_t chemical);

    const Experiment& experiment_;
    bool places_;  // cells lie in columns and rows: fields are known
    std::size_t rule_;
    Numbers& numbers_;
    std::uint32_t randoms_ = 0;
    std::size_t parts_ = 0;  // of expressions
    std::set<std::uint32_t> declared_;
    std::string pending_;
    std::string shared_;
    RuleUse use_;
};

}  // namespace pelage
