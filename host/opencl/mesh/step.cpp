// See step.hpp.
#include "opencl/mesh/step.hpp"

#include "opencl/device/program.hpp"
#include "opencl/device/rule_options.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <variant>

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
            if (i % 2 == 0) text += amounts("LOAD", "c", i, "first");
            text += fmt::format("real n{0} = c{0};\n", i);
            if (reads_rate(i)) text += fmt::format("const real r{} = {};\n", i, rate(i));
            if (writes_rates_) text += fmt::format("real q{0} = r{0};\n", i);
        }
        for (std::size_t i = 0; i < experiment_.mappings.size(); ++i) {
            if (maps(i)) text += fmt::format("real m{0} = LOAD(PLANE_OF(mapping, {0}) + first);\n", i);
        }
        return text + blobs();
    }

    // Fields of blobs lie behind the coordinates.
    std::string blobs() const {
        std::string text;
        std::size_t plane = 3;
        for (std::size_t i = 0; i < experiment_.fields.size(); ++i) {
            if (!std::holds_alternative<BlobField>(experiment_.fields[i].source)) continue;
            if (rules_.use.fields.contains(i))
                text += fmt::format("const real z{} = LOAD(PLANE_OF(places, {}) + first);\n", i, plane);
            ++plane;
        }
        return text;
    }

    // The amounts of the pair of chemicals that begins with i, or of i alone if it is the last.
    std::string amounts(const char* how, const char* name, std::size_t i, const char* where) const {
        if (i + 1 < chemicals())
            return fmt::format("{0}_PAIR({1}{2}, {1}{3}, PLANE_OF(old_conc, {2}), {4})\n", how, name, i, i + 1, where);
        return fmt::format("{0}_ALONE({1}{2}, PLANE_OF(old_conc, {2}), {3})\n", how, name, i, where);
    }

    // What the neighbours hold of these chemicals and of those that they are paired with.
    std::string theirs(const std::set<std::size_t>& wanted) const {
        std::string text;
        for (std::size_t i = 0; i < chemicals(); i += 2) {
            if (wanted.contains(i) || wanted.contains(i + 1)) text += amounts("GATHER", "o", i, "there");
        }
        return text;
    }

    // One number serves all cells where all have the same.
    std::string rate(std::size_t i) const {
        if (rates_[i] == RateKind::uniform && !writes_rates_) return fmt::format("R(PLANE_OF(old_rate, {})[0])", i);
        return fmt::format("LOAD(PLANE_OF(old_rate, {}) + first)", i);
    }

    // Laplacians that rules read.
    std::string look() const {
        if (rules_.use.laplacians.empty()) return {};
        std::string before, each = theirs(rules_.use.laplacians);
        for (const std::size_t i : rules_.use.laplacians) {
            before += fmt::format("real lap{} = R(0);\n", i);
            each += fmt::format("lap{0} = SELECT(listed, fma(share, o{0} - c{0}, lap{0}), lap{0});\n", i);
        }
        return before +
               "for (int k = 0; k < longest; ++k) {\nconst mask listed = LISTED(k);\n"
               "const uintv there = LOAD(indices + list + k * 16L);\n"
               "const real share = LOAD(weights + list + k * 16L);\n" +
               each + "}\n";
    }

    std::string neighbour() const {
        std::set<std::size_t> spread;
        for (std::size_t i = 0; i < chemicals(); ++i) {
            if (rates_[i] != RateKind::none) spread.insert(i);
        }
        std::string text = theirs(spread);
        for (const std::size_t i : spread) {
            const std::string rate =
                rates_[i] == RateKind::uniform
                    ? fmt::format("r{}", i)
                    : fmt::format("pelage_shared_rate(r{0}, GATHER(PLANE_OF(old_rate, {0}), there))", i);
            text += fmt::format("n{0} = SELECT(listed, FLOW(n{0}, {1}, share, o{0} - c{0}), n{0});\n", i, rate);
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
            if (i % 2 == 1) {
                text += fmt::format("STORE_PAIR(n{0}, n{1}, PLANE_OF(new_conc, {0}), first);\n", i - 1, i);
            } else if (i + 1 == chemicals()) {
                text += fmt::format("STORE(n{0}, PLANE_OF(new_conc, {0}) + first);\n", i);
            }
            if (writes_rates_) text += fmt::format("STORE(q{0}, PLANE_OF(new_rate, {0}) + first);\n", i);
        }
        for (const std::size_t i : rules_.use.mappings_written)
            text += fmt::format("STORE(m{0}, PLANE_OF(mapping, {0}) + first);\n", i);
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
    : session_(session), seed_(static_cast<std::uint64_t>(experiment.run_seed())), lanes_(lanes_for(session)) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    writes_rates_ = !rules.use.rates_written.empty();
    Source source;
    source.text(fmt::format("#define PELAGE_WIDTH {}\n", lanes_));
    source.file("common/prelude.cl").file("common/gather.cl").file("rules/philox.cl").file("common/exchange.cl");
    for (const std::string& file : rule_files(rules.use)) source.file(file);
    source.file("mesh/pairs.cl").file("mesh/step.cl", MeshEmitter(experiment, rates, rules).fills());
    kernel_ = cl::Kernel(session.build(source.str(), rule_options(session)), "pelage_mesh_step");
}

// Work-items in a group: few enough for every thread to get some of a small mesh.
std::size_t MeshStep::group_for(std::size_t items) const {
    if (session_.options().work_group != 0) return session_.options().work_group;
    return lanes_ == 1 || items > 3000 ? 64 : 16;
}

void MeshStep::enqueue(MeshState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                       Pace& pace) {
    const std::size_t items = state.pitch() / lanes_;
    const std::size_t group = group_for(items);
    for (std::uint64_t done = 0; done < count; ++done) {
        Arguments arguments(session_, kernel_);
        state.add_to(arguments, writes_rates_);
        arguments.add(parameters, state.pitch(), static_cast<cl_uint>(first + done),
                      static_cast<cl_uint>(seed_ & 0xffffffffu), static_cast<cl_uint>(seed_ >> 32));
        launch(session_, kernel_, items, group);
        pace.launched();
        state.swap(writes_rates_);
    }
}

}  // namespace pelage
