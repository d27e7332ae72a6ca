// See step.hpp.
#include "opencl/mesh/step.hpp"

#include "opencl/device/program.hpp"
#include "opencl/device/rule_options.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

namespace pelage {

namespace {

enum MeshPlace : std::size_t { dt_place, time_start_place, time_begin_place, bounds_place };

std::size_t rules_place(const Experiment& experiment) {
    return numbers_begin(bounds_place + 2 * experiment.chemicals.size());
}

// The texts that fill the kernel.
class MeshEmitter {
public:
    MeshEmitter(const Experiment& experiment, const std::vector<RateKind>& rates, const RuleText& rules)
        : experiment_(experiment), rates_(rates), rules_(rules), writes_rates_(!rules.use.rates_written.empty()) {}

    std::map<std::string, std::string> fills() const {
        return {{"parameters", rules_.numbers.declarations(rules_place(experiment_))},
                {"cell", cell()},
                {"look", look()},
                {"rules", rules_.shared + rules_.rules},
                {"neighbour", neighbour()},
                {"finish", finish()}};
    }

private:
    std::size_t chemicals() const { return experiment_.chemicals.size(); }
    bool reads_rate(std::size_t i) const {
        return writes_rates_ || rates_[i] != RateKind::none || rules_.use.rates_read.contains(i);
    }
    bool maps(std::size_t i) const {
        return rules_.use.mappings_read.contains(i) || rules_.use.mappings_written.contains(i);
    }

    std::string cell() const {
        std::string text;
        for (std::size_t i = 0; i < chemicals(); ++i) {
            text += fmt::format("const real c{0} = PLANE_OF(old_conc, {0})[at];\nreal n{0} = c{0};\n", i);
            if (reads_rate(i)) text += fmt::format("const real r{0} = PLANE_OF(old_rate, {0})[at];\n", i);
            if (writes_rates_) text += fmt::format("real q{0} = r{0};\n", i);
        }
        for (std::size_t i = 0; i < experiment_.mappings.size(); ++i) {
            if (maps(i)) text += fmt::format("real m{0} = PLANE_OF(mapping, {0})[at];\n", i);
        }
        return text;
    }

    // Laplacians that rules read.
    std::string look() const {
        if (rules_.use.laplacians.empty()) return {};
        std::string before, each;
        for (const std::size_t i : rules_.use.laplacians) {
            before += fmt::format("real lap{} = R(0);\n", i);
            each += fmt::format(
                "lap{0} = fma(R(weights[entry]), PLANE_OF(old_conc, {0})[indices[entry]] - c{0}, lap{0});\n", i);
        }
        return before + "for (uint entry = begin; entry < end; ++entry) {\n" + each + "}\n";
    }

    std::string neighbour() const {
        std::string text;
        for (std::size_t i = 0; i < chemicals(); ++i) {
            if (rates_[i] == RateKind::none) continue;
            const std::string rate = rates_[i] == RateKind::uniform
                                         ? fmt::format("r{}", i)
                                         : fmt::format("pelage_shared_rate(r{0}, PLANE_OF(old_rate, {0})[there])", i);
            text += fmt::format("n{0} = FLOW(n{0}, {1}, share, PLANE_OF(old_conc, {0})[there] - c{0});\n", i, rate);
        }
        return text;
    }

    std::string finish() const {
        std::string text = rules_.replace;
        const std::vector<bool> bounded = bounded_somewhen();
        for (std::size_t i = 0; i < chemicals(); ++i) {
            if (bounded[i])
                text += fmt::format("n{0} = HELD(n{0}, R(parameters[{1}]), R(parameters[{2}]));\n", i,
                                    bounds_place + 2 * i, bounds_place + 2 * i + 1);
            text += fmt::format("PLANE_OF(new_conc, {0})[at] = n{0};\n", i);
            if (writes_rates_) text += fmt::format("PLANE_OF(new_rate, {0})[at] = q{0};\n", i);
        }
        for (const std::size_t i : rules_.use.mappings_written)
            text += fmt::format("PLANE_OF(mapping, {0})[at] = m{0};\n", i);
        return text;
    }

    std::vector<bool> bounded_somewhen() const {
        std::vector<bool> bounded(chemicals(), false);
        for (const Phase& phase : experiment_.phases) {
            for (std::size_t i = 0; i < bounded.size(); ++i)
                bounded[i] = bounded[i] || std::isfinite(phase.bounds[i].floor) || std::isfinite(phase.bounds[i].limit);
        }
        return bounded;
    }

    const Experiment& experiment_;
    const std::vector<RateKind>& rates_;
    const RuleText& rules_;
    bool writes_rates_;
};

}  // namespace

std::vector<KernelNumber> mesh_parameters(const Experiment& experiment, const Phase& phase, Precision precision) {
    std::vector<KernelNumber> values(bounds_place, 0.0);
    values[dt_place] = phase.time_step;
    values[time_start_place] = experiment.time_at(phase.begin);
    values[time_begin_place] = static_cast<std::uint32_t>(phase.begin);
    for (const Bounds& bounds : phase.bounds) values.insert(values.end(), {bounds.floor, bounds.limit});
    values.resize(rules_place(experiment));
    const std::vector<KernelNumber> of_rules = rule_parameters(experiment, precision);
    values.insert(values.end(), of_rules.begin(), of_rules.end());
    return values;
}

MeshStep::MeshStep(const Session& session, const Experiment& experiment, const std::vector<RateKind>& rates,
                   const std::vector<bool>& active, bool test_intervals)
    : session_(session), seed_(static_cast<std::uint64_t>(experiment.run_seed())) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    writes_rates_ = !rules.use.rates_written.empty();
    Source source;
    source.file("common/prelude.cl").file("rules/philox.cl").file("common/exchange.cl");
    for (const std::string& file : rule_files(rules.use)) source.file(file);
    source.file("mesh/step.cl", MeshEmitter(experiment, rates, rules).fills());
    kernel_ = cl::Kernel(session.build(source.str(), rule_options(session)), "pelage_mesh_step");
}

void MeshStep::enqueue(MeshState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                       Pace& pace) {
    constexpr std::size_t wanted_group = 64;
    const std::size_t group = session_.options().work_group != 0 ? session_.options().work_group : wanted_group;
    for (std::uint64_t done = 0; done < count; ++done) {
        Arguments arguments(session_, kernel_);
        state.add_to(arguments, writes_rates_);
        arguments.add(parameters, state.cells(), static_cast<cl_uint>(first + done),
                      static_cast<cl_uint>(seed_ & 0xffffffffu), static_cast<cl_uint>(seed_ >> 32));
        launch(session_, kernel_, state.cells(), group);
        pace.launched();
        state.swap(writes_rates_);
    }
}

}  // namespace pelage
