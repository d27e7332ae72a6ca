// See programs.hpp.
#include "opencl/cells/programs.hpp"

#include "core/schedule.hpp"
#include "opencl/device/rule_options.hpp"

#include <algorithm>

namespace pelage {

namespace {

// Rules that come and go faster than this are tested by the kernel, so that steps can still be enqueued in batches.
constexpr std::uint64_t shortest_stretch = 32;

// Rules that act somewhere in [iteration, iteration + shortest_stretch), and the first iteration at which another does.
std::vector<bool> active_soon(const Experiment& experiment, std::uint64_t iteration, std::uint64_t& until) {
    std::vector<bool> active;
    until = forever;
    for (const Rule& rule : experiment.rules) {
        const std::uint64_t next = next_active(rule, iteration);
        active.push_back(next < iteration + shortest_stretch);
        if (!active.back()) until = std::min(until, next);
    }
    return active;
}

}  // namespace

CellsPrograms::CellsPrograms(const Session& session, const Experiment& experiment, CellsPlan plan)
    : session_(session), experiment_(experiment), plan_(std::move(plan)), width_(lanes_for(session)) {}

CellsStep& CellsPrograms::at(std::uint64_t iteration, std::uint64_t& until, CellsForm form) {
    std::vector<bool> active = active_rules(experiment_, iteration);
    until = next_change(experiment_, iteration);
    const bool brief = until - iteration < shortest_stretch;
    if (brief) active = active_soon(experiment_, iteration, until);
    const Phase& phase = experiment_.phase_at(iteration);
    upload(phase);
    const auto place = static_cast<std::size_t>(&phase - experiment_.phases.data());
    const Key key{form, place, brief, active};
    const auto known = steps_.find(key);
    if (known != steps_.end()) return known->second;
    const CellsSource source =
        cells_step_source(experiment_, active, brief, phase, plan_, session_.options().precision, width_, form);
    const cl::Program program = session_.build(source.text, rule_options(session_));
    const char* name = form == CellsForm::alone ? "pelage_cells_step" : "pelage_cells_together";
    CellsStep step{cl::Kernel(program, name), cl::Kernel(program, name), source.written};
    return steps_.emplace(key, std::move(step)).first->second;
}

void CellsPrograms::upload(const Phase& phase) {
    if (uploaded_ == &phase) return;
    const Precision precision = session_.options().precision;
    const std::vector<std::uint32_t> words =
        parameter_words(cells_parameters(experiment_, phase, precision), precision);
    const std::size_t bytes = words.size() * sizeof words[0];
    if (uploaded_ == nullptr) parameters_ = session_.buffer(bytes, "parameters");
    session_.queue().enqueueWriteBuffer(parameters_, CL_TRUE, 0, bytes, words.data());
    uploaded_ = &phase;
}

}  // namespace pelage
