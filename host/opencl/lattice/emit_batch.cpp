// See emit_batch.hpp.
#include "opencl/lattice/emit_batch.hpp"

#include "opencl/lattice/emit_lattice.hpp"

#include <fmt/format.h>

namespace pelage {

std::size_t batch_stride(std::size_t count) { return numbers_begin(count + 2); }

std::string batch_text(const Experiment& experiment, const LatticePlan& plan, const RuleText& rules,
                       const std::vector<std::string>& mapping_buffers) {
    std::string text = "const long member = members[get_global_id(2)];\n";
    const auto move = [&](const std::string& buffer, std::size_t planes) {
        if (planes > 0) text += fmt::format("{} += member * {} * plane;\n", buffer, planes);
    };
    for (const char* parity : {"even", "odd"}) {
        move(fmt::format("{}_conc", parity), experiment.chemicals.size());
        move(fmt::format("{}_rate", parity), own_rates(plan));
        move(fmt::format("{}_polarity", parity), plan.polarity ? 2 : 0);
    }
    for (const std::string& buffer : mapping_buffers) move(buffer, experiment.mappings.size());
    const auto& read = rules.use.quantities;
    move("birth", read.contains(Quantity::age) || read.contains(Quantity::birth) ? 1 : 0);
    move("neighbours", read.contains(Quantity::neighbours) ? 1 : 0);
    move("fields", experiment.fields.size());
    const std::size_t own = parameter_place(experiment.chemicals.size(), LatticeParameter::floor);
    const std::size_t stride = batch_stride(own + rules.numbers.values().size());
    text += fmt::format("parameters += member * {};\n", stride);
    return text +
           fmt::format("seed_low = PARAMETER_WORD({});\nseed_high = PARAMETER_WORD({});\n", stride - 2, stride - 1);
}

}  // namespace pelage
