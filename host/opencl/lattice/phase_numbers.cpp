// See phase_numbers.hpp.
#include "opencl/lattice/phase_numbers.hpp"

#include "core/subnormal.hpp"
#include "opencl/lattice/emit_lattice.hpp"

#include <cstdint>

namespace pelage {

namespace {

template <class T>
std::vector<KernelNumber> numbers_in(const Experiment& experiment, const LatticePlan& plan,
                                     const std::vector<double>& rates, const Phase& phase) {
    const T dt = in_precision<T>(phase.time_step);
    std::vector<KernelNumber> values(parameter_place(experiment.chemicals.size(), LatticeParameter::floor), double{dt});
    values[time_start_place] = experiment.time_at(phase.begin);
    values[time_begin_place] = static_cast<std::uint32_t>(phase.begin);
    for (std::size_t i = 0; i < experiment.chemicals.size(); ++i) {
        const auto put = [&](LatticeParameter what, T value) { values[parameter_place(i, what)] = double{value}; };
        const T rate = in_precision<T>(rates[i]);
        put(LatticeParameter::floor, in_precision<T>(phase.bounds[i].floor));
        put(LatticeParameter::limit, in_precision<T>(phase.bounds[i].limit));
        put(LatticeParameter::rate, rate);
        put(LatticeParameter::share, (rate * dt) / static_cast<T>(stencil_divisor(plan.stencil)));
    }
    return values;
}

}  // namespace

std::vector<KernelNumber> phase_numbers(const Experiment& experiment, const LatticePlan& plan,
                                        const std::vector<double>& rates, const Phase& phase, Precision precision) {
    if (precision == Precision::double_) return numbers_in<double>(experiment, plan, rates, phase);
    const SubnormalsAreZero scope;
    return numbers_in<float>(experiment, plan, rates, phase);
}

}  // namespace pelage
