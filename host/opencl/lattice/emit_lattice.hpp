// The source of a lattice's step for one set of active rules.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "core/tissue.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

// Numbers that the step reads from its buffer of parameters: dt, the time at which the phase begins and its first
// iteration, from place 4 on for each chemical these four, then those of rules.
inline constexpr std::size_t time_start_place = 1, time_begin_place = 2;
enum class LatticeParameter { floor, limit, rate, share };  // share: rate * dt / divisor of the stencil
inline std::size_t parameter_place(std::size_t chemical, LatticeParameter what) {
    return 4 + 4 * chemical + static_cast<std::size_t>(what);
}

// Places of the chemicals with rates of their own among the planes of rates, in order of chemical.
std::vector<std::size_t> rate_planes(const LatticePlan&);  // npos where the chemical has none
std::size_t own_rates(const LatticePlan&);                 // chemicals that have
inline constexpr std::size_t no_plane = static_cast<std::size_t>(-1);

// 6 for nine_point, 20 for sims, 30 for twenty_seven_point, 1 for the others.
double stencil_divisor(Stencil);

// Chemicals that have a finite bound in some phase.
std::vector<bool> bounded_chemicals(const Experiment&);

// The loop over a cell's neighbours (kernels/lattice/neighbours.cl, or volume/). `visit`: what is done for each.
std::string neighbours_text(const std::string& visit, bool volume = false);

// The defines that every program of a lattice begins with. `width`: see PELAGE_WIDTH.
std::string lattice_settings(const LatticePlan&, std::size_t width);

// Declares floor<i>, limit<i>, r<i> and share<i> where a kernel has use for them, and the numbers of rules.
std::string emit_parameters(const LatticePlan&, const std::vector<bool>& bounded, const Numbers& of_rules);

// `bounded`: chemicals that have a finite bound in some phase. `width`: see PELAGE_WIDTH. `together`: see
// kernels/lattice/together.cl. `means`: see kernels/lattice/means.cl. `batch`: see emit_batch.hpp.
std::string lattice_source(const Experiment&, const LatticePlan&, const RuleText&, const std::vector<bool>& bounded,
                           Precision, std::size_t width, bool together, bool means, bool batch = false);

}  // namespace pelage
