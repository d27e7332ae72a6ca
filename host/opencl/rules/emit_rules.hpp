// The rules of an experiment as OpenCL C, for lattices and free cells alike.
//
// The kernel around the emitted text provides, for one work-item (types as in kernels/common/prelude.cl):
//   const real c0, c1, ...      old concentrations           real n0, n1, ...   new ones, set to the old before `rules`
//   const real r0, r1, ...      old rates, where read        real q0, q1, ...   new ones, alike, where written
//   const real lap0, lap1, ...  laplacians of chemicals, where read; slope_x0, slope_y0, slope_z0, ... their gradients
//   AROUND(a0, side, up)        chemical 0 in the cell so many columns and rows away, where RuleUse::surrounds
//   const real z0, z1, ...      fields of a lattice, and of blobs on a mesh, where read
//   real m0, m1, ...            mappings of the cell, loaded before and stored after `rules`; where used
//   const real px, py           old polarity, where RuleUse::polarity
//   const real dt               time step
//   const real time_start; const uint time_begin        time and iteration at which the phase began, where TIME is read
//   numbers.declarations() of the RuleText
//   const uintv id; const uint iteration, seed_low, seed_high          where RuleUse::random (iteration: always)
//   and as macros, where RuleUse::quantities says so, of type real:  GET_X  GET_Y  GET_Z
//   and of type uintv:  WHOLE_NEIGHBOURS  WHOLE_AGE  WHOLE_BIRTH  WHOLE_COLUMN
//   and of type uint, one for all lanes:  WHOLE_ROW  WHOLE_LAYER  WHOLE_ROWS  WHOLE_COLUMNS  WHOLE_LAYERS
// The emitted text declares
//   mask t0, t1, ...            where the rule of that number acts
//   real or mask x0_0, x0_1 ... parts of the expressions of that rule
//   mask e0.., real s0..        RuleUse::sets: where a `set` replaces the new concentration, and by what
//   mask g0, g1, ...            RuleUse::polarizes: where the polarity shall follow that chemical's gradient
// and leaves divisions and moves to macros of the kernel:
//   DIVIDE(nth, rule, where, degrees)     the nth `divide` rule of the experiment; degrees relative to the polarity
//   MOVE(where, distance)                 along the old polarity
// There is no control flow but `if (ANY(mask))` around draws, expressions and networks, so that `real` may be a vector.
#pragma once

#include "core/experiment.hpp"
#include "core/tissue.hpp"
#include "opencl/rules/numbers.hpp"

#include <set>
#include <string>
#include <vector>

namespace pelage {

struct RuleUse {                                // what the emitted rules need of the kernel
    std::set<std::size_t> concentrations_read;  // as operands, or by reactions that keep them
    std::set<std::size_t> concentrations_written;
    std::set<std::size_t> rates_read;
    std::set<std::size_t> rates_written;
    std::set<std::size_t> mappings_read;
    std::set<std::size_t> mappings_written;
    std::set<std::size_t> sets;        // chemicals with a remembered `set` of the concentration
    std::set<std::size_t> polarizes;   // chemicals
    std::set<std::size_t> reacts;      // places in model_table(): kernels/models/NAME.cl must come before
    std::set<std::size_t> laplacians;  // of chemicals
    std::set<std::size_t> gradients;   // of chemicals, along rows or columns
    std::set<std::size_t> surrounds;   // chemicals that stencils with names are taken of
    std::size_t reach = 1;             // of those stencils
    std::set<std::size_t> fields;      // of a lattice; of blobs on a mesh
    std::set<std::size_t> functions;   // places in function_table(): kernels/functions/NAME.cl must come before
    std::set<Quantity> quantities;     // those read that are neither numbers nor indexed
    bool neural = false;               // kernels/rules/neural.cl must come before
    bool random = false;
    bool polarity = false;  // some rule moves or divides
    bool divides = false;

    bool operator==(const RuleUse&) const = default;
};

struct RuleText {
    std::string
        shared;         // what is the same for all cells in an iteration; reads `iteration`, dt, the begin of the phase
    std::string rules;  // after that; declarations included; `set` and clamping of rates too
    std::string replace;  // after diffusion, before the bounds: `set` of concentrations
    RuleUse use;
    Numbers numbers;  // those of all rules; declared are those of the rules that are not left out
};

// Rules that are not active are left out; `expand` rules always. With `test_intervals` the kernel itself tests
// whether each of the rules in `active` acts at `iteration`, so that one program fits all iterations.
RuleText emit_rules(const Experiment&, const std::vector<bool>& active, Precision, bool test_intervals = false);

// The numbers of the rules alone.
std::vector<KernelNumber> rule_parameters(const Experiment&, Precision);

// A number as written in OpenCL C, exactly: "R(0x1.8p+0f)".
std::string emit_number(double value, Precision);

// The files of every function and model used, in order, relative to kernels/: functions/NAME.cl, rules/reaction.cl,
// models/NAME.cl.
std::vector<std::string> rule_files(const RuleUse&);

}  // namespace pelage
