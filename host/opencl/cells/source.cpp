// See source.hpp.
#include "opencl/cells/source.hpp"

#include "core/error.hpp"
#include "opencl/device/program.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

namespace pelage {

namespace {

// Places in the buffer of parameters; after them floor and limit of each chemical, then the numbers of rules.
enum Place : std::size_t {
    seed_low_place,
    seed_high_place,
    dt_place,
    time_start_place,
    time_begin_place,
    division_limit_place,
    bounds_place
};

std::size_t rules_place(const Experiment& experiment) {
    return numbers_begin(bounds_place + 2 * experiment.chemicals.size());
}

// Puts together the texts that fill the kernel.
class StepEmitter {
public:
    StepEmitter(const Experiment& experiment, const RuleText& rules, const Phase& phase, const CellsPlan& plan,
                Precision precision)
        : experiment_(experiment), rules_(rules), phase_(phase), plan_(plan), precision_(precision) {
        written_.rate = plan.mirrors || !rules.use.rates_written.empty();
        written_.polarity = !rules.use.polarizes.empty();
        written_.mapping = !rules.use.mappings_written.empty();
    }

    const CellsWritten& written() const { return written_; }

    std::string load() {
        line("const uint seed_low = PARAMETER_WORD({});", std::size_t{seed_low_place});
        line("const uint seed_high = PARAMETER_WORD({});", std::size_t{seed_high_place});
        line("const real dt = {};", parameter(dt_place));
        if (rules_.use.quantities.contains(Quantity::time)) {
            line("const real time_start = {};", parameter(time_start_place));
            line("const uint time_begin = PARAMETER_WORD({});", std::size_t{time_begin_place});
        }
        text_ += rules_.numbers.declarations(rules_place(experiment_));
        if (rules_.use.random) line("const uintv id = AS_UINTV(LOAD(id_old + first));");
        if (experiment_.division_limit == 0) {
            line("const mask may_divide = ALL_TRUE;");
        } else {
            line("const mask may_divide = TO_MASK(LOAD(neighbours_old + first) <= (intv)((int)PARAMETER_WORD({})));",
                 std::size_t{division_limit_place});
        }
        for (std::size_t i = 0; i < chemicals(); ++i) {
            line("const real c{0} = LOAD(conc_old + {0}L * pitch + first);", i);
            line("real n{0} = c{0};", i);
            if (needs_rate(i)) line("const real r{0} = LOAD(rate_old + {0}L * pitch + first);", i);
            if (written_.rate) line("real q{0} = r{0};", i);
        }
        for (std::size_t i = 0; i < experiment_.mappings.size(); ++i) {
            if (needs_mapping(i)) line("real m{0} = LOAD(mapping_old + {0}L * pitch + first);", i);
        }
        if (needs_polarity()) {
            line("const real px = LOAD(polarity_old + first);");
            line("const real py = LOAD(polarity_old + pitch + first);");
        }
        return take();
    }

    // Mappings are final, and what gathers along the neighbours starts.
    std::string mappings() {
        for (std::size_t i = 0; written_.mapping && i < experiment_.mappings.size(); ++i) {
            line("STORE(m{0}, mapping_new + {0}L * pitch + first);", i);
        }
        if (written_.polarity) line("mask met = ALL_FALSE;");
        for (const std::size_t i : rules_.use.polarizes) line("real gx{0} = R(0);\nreal gy{0} = R(0);", i);
        return take();
    }

    std::string neighbour() {
        if (anisotropic()) {
            line("const real other_px = GATHER(polarity_old, other);");
            line("const real other_py = GATHER(polarity_old + pitch, other);");
            line(
                "const real along = SELECT(((px == R(0)) & (py == R(0))) | (norm == R(0)), R(1), "
                "fabs(dx * px + dy * py) / norm);");
            line(
                "const real other_along = SELECT(((other_px == R(0)) & (other_py == R(0))) | (norm == R(0)), R(1), "
                "fabs(dx * other_px + dy * other_py) / norm);");
        }
        if (written_.polarity) {
            line("const mask apart = near & (norm != R(0));");
            line("met = met | (near & (norm == R(0)));");
        }
        for (std::size_t i = 0; i < chemicals(); ++i) exchange(i);
        return take();
    }

    std::string finish() {
        text_ += rules_.replace;
        for (std::size_t i = 0; i < chemicals(); ++i) {
            bound(i);
            line("STORE(n{0}, conc_new + {0}L * pitch + first);", i);
            if (written_.rate) line("STORE(q{0}, rate_new + {0}L * pitch + first);", i);
        }
        if (written_.polarity) polarity();
        return take();
    }

private:
    template <class... Values>
    void line(fmt::format_string<Values...> format, Values&&... values) {
        text_ += fmt::format(format, std::forward<Values>(values)...) + "\n";
    }

    std::string take() { return std::exchange(text_, ""); }
    std::string number(double value) const { return emit_number(value, precision_); }
    std::string parameter(std::size_t place) const { return fmt::format("R(parameters[{}])", place); }
    std::size_t chemicals() const { return experiment_.chemicals.size(); }
    bool diffuses(std::size_t i) const { return plan_.rates[i] != RateKind::none; }
    bool anisotropic(std::size_t i) const { return diffuses(i) && experiment_.chemicals[i].anisotropic; }

    bool anisotropic() const {
        for (std::size_t i = 0; i < chemicals(); ++i) {
            if (anisotropic(i)) return true;
        }
        return false;
    }

    bool needs_polarity() const { return written_.polarity || rules_.use.polarity || anisotropic(); }
    bool needs_rate(std::size_t i) const { return written_.rate || diffuses(i) || rules_.use.rates_read.contains(i); }
    bool needs_mapping(std::size_t i) const { return written_.mapping || rules_.use.mappings_read.contains(i); }

    // What one neighbour adds to chemical i and to its gradient.
    void exchange(std::size_t i) {
        const bool follows = rules_.use.polarizes.contains(i);
        if (!diffuses(i) && !follows) return;
        line("const real step{0} = GATHER(conc_old + {0}L * pitch, other) - c{0};", i);
        if (diffuses(i)) diffuse(i);
        if (!follows) return;
        line("gx{0} = SELECT(apart, gx{0} + (step{0} * dx) / norm, gx{0});", i);
        line("gy{0} = SELECT(apart, gy{0} + (step{0} * dy) / norm, gy{0});", i);
    }

    void diffuse(std::size_t i) {
        const bool uniform = plan_.rates[i] == RateKind::uniform;
        if (uniform && !anisotropic(i)) {
            line("n{0} = SELECT(near, n{0} + ((r{0} * step{0}) * dt), n{0});", i);
            return;
        }
        const std::string theirs =
            uniform ? fmt::format("r{}", i) : fmt::format("GATHER(rate_old + {}L * pitch, other)", i);
        line("const real mine{0} = r{0}{1};", i, anisotropic(i) ? " * along" : "");
        line("const real theirs{0} = {1}{2};", i, theirs, anisotropic(i) ? " * other_along" : "");
        line("real shared{0} = mine{0};", i);
        line("const mask unlike{0} = !(mine{0} == theirs{0});", i);
        line(
            "if (ANY(unlike{0})) shared{0} = SELECT(unlike{0}, (R(2) * (mine{0} * theirs{0})) / (mine{0} + theirs{0}), "
            "mine{0});",
            i);
        line("n{0} = SELECT(near, n{0} + ((shared{0} * step{0}) * dt), n{0});", i);
    }

    void bound(std::size_t i) {
        const Bounds& bounds = phase_.bounds[i];
        const std::string floor = parameter(bounds_place + 2 * i);
        const std::string limit = parameter(bounds_place + 2 * i + 1);
        std::string value = fmt::format("n{}", i);
        if (!std::isinf(bounds.limit)) value = fmt::format("SELECT(n{0} > {1}, {1}, {2})", i, limit, value);
        if (!std::isinf(bounds.floor)) value = fmt::format("SELECT(n{0} < {1}, {1}, {2})", i, floor, value);
        line("n{} = {};", i, value);
    }

    // A cell that met another at its own place keeps its polarity: the published program's gradient is no number there.
    void polarity() {
        line("real new_px = px;\nreal new_py = py;");
        for (const std::size_t i : rules_.use.polarizes) {
            line("{{");
            line("const real steepness = sqrt(gx{0} * gx{0} + gy{0} * gy{0});", i);
            line("const mask turns = g{} & !met & (steepness > {});", i, number(0.0001));
            line("new_px = SELECT(turns, gx{} / steepness, new_px);", i);
            line("new_py = SELECT(turns, gy{} / steepness, new_py);", i);
            line("}}");
        }
        line("STORE(new_px, polarity_new + first);");
        line("STORE(new_py, polarity_new + pitch + first);");
    }

    const Experiment& experiment_;
    const RuleText& rules_;
    const Phase& phase_;
    const CellsPlan& plan_;
    Precision precision_;
    CellsWritten written_;
    std::string text_;
};

}  // namespace

CellsPlan cells_plan(const Experiment& experiment, const Snapshot& state, bool all_listed) {
    CellsPlan plan;
    for (std::size_t i = 0; i < experiment.chemicals.size(); ++i) {
        plan.rates.push_back(rate_kind(experiment, state.diff[i], i));
    }
    plan.mirrors = !state.mirrors.empty();
    plan.all_listed = all_listed;
    return plan;
}

bool changes(const CellsWritten& written, CellArray array) {
    switch (array) {
        case CellArray::position:
        case CellArray::conc:
        case CellArray::neighbours:
            return true;
        case CellArray::rate:
            return written.rate;
        case CellArray::polarity:
            return written.polarity;
        case CellArray::mapping:
            return written.mapping;
        default:
            return false;
    }
}

std::vector<KernelNumber> cells_parameters(const Experiment& experiment, const Phase& phase, Precision precision) {
    const auto seed = static_cast<std::uint64_t>(experiment.run_seed());
    std::vector<KernelNumber> values(bounds_place, 0.0);
    values[seed_low_place] = static_cast<std::uint32_t>(seed);
    values[seed_high_place] = static_cast<std::uint32_t>(seed >> 32);
    values[dt_place] = phase.time_step;
    values[time_start_place] = experiment.time_at(phase.begin);
    values[time_begin_place] = static_cast<std::uint32_t>(phase.begin);
    values[division_limit_place] =
        static_cast<std::uint32_t>(std::min<std::size_t>(experiment.division_limit, largest_cell_count));
    for (const Bounds& bounds : phase.bounds) values.insert(values.end(), {bounds.floor, bounds.limit});
    values.resize(rules_place(experiment));
    const std::vector<KernelNumber> of_rules = rule_parameters(experiment, precision);
    values.insert(values.end(), of_rules.begin(), of_rules.end());
    return values;
}

CellsSource cells_step_source(const Experiment& experiment, const std::vector<bool>& active, bool test_intervals,
                              const Phase& phase, const CellsPlan& plan, Precision precision, std::size_t width,
                              CellsForm form) {
    const RuleText rules = emit_rules(experiment, active, precision, test_intervals);
    StepEmitter emitter(experiment, rules, phase, plan, precision);
    Source source;
    source.text(fmt::format("#define PELAGE_PUBLISHED\n#define PELAGE_WIDTH {}\n", width));
    if (plan.all_listed) source.text("#define PELAGE_ALL_LISTED\n");
    if (plan.mirrors) source.text("#define PELAGE_MIRRORS\n");
    if (rules.use.divides) source.text("#define PELAGE_DIVIDES\n");
    source.file("common/prelude.cl").file("common/gather.cl").file("rules/philox.cl");
    for (const std::string& file : rule_files(rules.use)) source.file(file);
    source.file("cells/state.cl");
    source.file("cells/step.cl", {{"LOAD", emitter.load()},
                                  {"RULES", rules.shared + rules.rules},
                                  {"MAPPINGS", emitter.mappings()},
                                  {"NEIGHBOUR", emitter.neighbour()},
                                  {"FINISH", emitter.finish()}});
    if (form == CellsForm::alone) {
        source.file("cells/alone.cl");
    } else {
        source.file("common/scan.cl").file("common/list.cl");
        if (rules.use.divides) source.file("cells/divide.cl");
        if (plan.mirrors) source.file("cells/mirror.cl");
        source.file("cells/together.cl");
    }
    return {source.str(), emitter.written()};
}

}  // namespace pelage
