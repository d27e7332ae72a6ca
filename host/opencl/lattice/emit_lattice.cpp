// See emit_lattice.hpp. The fragments fill the //@ lines of kernels/lattice/step.cl; for chemical i they name
//   a<i>, b<i>  planes of old and new concentrations     c<i>, n<i>  the cell's values
//   d<i>, f<i>  planes of old and new rates              r<i>, q<i>  the cell's values
#include "opencl/lattice/emit_lattice.hpp"

#include "opencl/device/program.hpp"
#include "opencl/lattice/emit_batch.hpp"
#include "opencl/lattice/traits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace pelage {

namespace {

const char* boundary_word(Boundary boundary) {
    switch (boundary) {
        case Boundary::no_flux:
            return "PELAGE_NO_FLUX";
        case Boundary::wrap:
            return "PELAGE_WRAP";
        case Boundary::absorbing:
            return "PELAGE_ABSORBING";
    }
    return "";
}

const char* stencil_word(Stencil stencil) {
    switch (stencil) {
        case Stencil::moore:
            return "PELAGE_MOORE";
        case Stencil::nine_point:
            return "PELAGE_NINE_POINT";
        case Stencil::five_point:
            return "PELAGE_FIVE_POINT";
        case Stencil::sims:
            return "PELAGE_SIMS";
        case Stencil::own:
            return "PELAGE_OWN_WEIGHTS";
        case Stencil::seven_point:
            return "PELAGE_SEVEN_POINT";
        case Stencil::twenty_seven_point:
            return "PELAGE_TWENTY_SEVEN_POINT";
    }
    return "";
}

class LatticeEmitter {
public:
    LatticeEmitter(const Experiment& experiment, const LatticePlan& plan, const RuleUse& use,
                   const std::vector<bool>& bounded, Precision precision, bool means)
        : experiment_(experiment),
          plan_(plan),
          use_(use),
          traits_(experiment, plan, use),
          bounded_(bounded),
          precision_(precision),
          means_(means),
          rate_planes_(rate_planes(plan)) {}

    std::map<std::string, std::string> fills(const RuleText& text) const {
        std::map<std::string, std::string> fills = cell_fills(text);
        if (!plan_.volume()) fills["start"] = start();  // of sums of rows
        return fills;
    }

    std::map<std::string, std::string> cell_fills(const RuleText& text) const {
        return {{"parameters", emit_parameters(plan_, bounded_, text.numbers)},
                {"planes", planes()},
                {"cell", cell()},
                {"shared", text.shared},
                {"rules", traits_.look() + text.rules},
                {"neighbours", traits_.visits() ? traits_.around(traits_.visit(means_)) : ""},
                {"replace", text.replace},
                {"finish", finish()},
                {"diffusion", diffusion()}};
    }

    std::string settings(std::size_t width) const {
        std::string text = lattice_settings(plan_, width);
        if (means_) text += "#define PELAGE_MEANS\n";
        text += traits_.shares(precision_);
        return text;
    }

private:
    // The format, with {0} the number, for every chemical that `wanted` names.
    std::string each(const char* format, const std::function<bool(std::size_t)>& wanted) const {
        std::string text;
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            if (wanted(i)) text += fmt::format(fmt::runtime(format), i) + "\n";
        }
        return text;
    }
    std::string each(const char* format) const {
        return each(format, [](std::size_t) { return true; });
    }
    auto all(bool (LatticeTraits::*is)(std::size_t) const) const {
        return [this, is](std::size_t i) { return (traits_.*is)(i); };
    }

    std::string planes() const {
        std::string text;
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            text += fmt::format(
                "global scalar* const a{0} = PLANE({1}, {0});\n"
                "global scalar* const b{0} = PLANE(new_conc, {0});\n",
                i, traits_.idle(i) ? "even_conc" : "old_conc");
        }
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            if (!traits_.per_cell(i)) continue;
            text += fmt::format("global scalar* const d{} = PLANE(old_rate, {});\n", i, rate_planes_[i]);
            if (means_) {
                text += fmt::format("global const scalar* const means{} = PLANE(means, {});\n", i, 4 * rate_planes_[i]);
            }
            if (traits_.writes_rates())
                text += fmt::format("global scalar* const f{} = PLANE(new_rate, {});\n", i, rate_planes_[i]);
        }
        for (std::size_t i = 0; i < experiment_.mappings.size(); ++i) {
            if (traits_.maps(i)) text += fmt::format("global scalar* const map{0} = PLANE(mapping, {0});\n", i);
        }
        for (const std::size_t i : use_.fields)
            text += fmt::format("global const scalar* const field{0} = PLANE(fields, {0});\n", i);
        if (traits_.polarity()) {
            text +=
                "global scalar* const old_px = PLANE(old_polarity, 0);\n"
                "global scalar* const old_py = PLANE(old_polarity, 1);\n";
        }
        if (traits_.turns()) {
            text +=
                "global scalar* const new_px = PLANE(new_polarity, 0);\n"
                "global scalar* const new_py = PLANE(new_polarity, 1);\n";
        }
        return text;
    }

    std::string start() const { return each("ROLL_START({0}, low)", all(&LatticeTraits::rolled)); }

    std::string cell() const {
        std::string text = each("ROLL_AHEAD({0}, row)", all(&LatticeTraits::rolled));
        text += each("const real c{0} = LOAD(a{0} + at);",
                     [this](std::size_t i) { return !traits_.rolled(i) && !traits_.idle(i); });
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            if (!traits_.idle(i)) continue;
            text += fmt::format(fmt::runtime(bounded_[i] ? "const real l{0} = LOAD(a{0} + at);\n"
                                                           "const real c{0} = step == 0 ? l{0} : HELD(l{0}, floor{0}, "
                                                           "limit{0});\n"
                                                         : "const real c{0} = LOAD(a{0} + at);\n"),
                                i);
        }
        text += each("real n{0} = c{0};");
        text += each("const real r{0} = LOAD(d{0} + at);", all(&LatticeTraits::per_cell));
        if (traits_.writes_rates()) text += each("real q{0} = r{0};", all(&LatticeTraits::per_cell));
        for (std::size_t i = 0; i < experiment_.mappings.size(); ++i) {
            if (traits_.maps(i)) text += fmt::format("real m{0} = LOAD(map{0} + at);\n", i);
        }
        for (const std::size_t i : use_.fields) text += fmt::format("const real z{0} = LOAD(field{0} + at);\n", i);
        if (traits_.polarity()) text += "const real px = LOAD(old_px + at);\nconst real py = LOAD(old_py + at);\n";
        for (const std::size_t i : use_.polarizes) text += fmt::format("real gx{0} = R(0);\nreal gy{0} = R(0);\n", i);
        return text;
    }

    std::string diffusion() const { return each("ROLL_DIFFUSE({0})", all(&LatticeTraits::rolled)); }

    std::string finish() const {
        std::string text =
            each("n{0} = HELD(n{0}, floor{0}, limit{0});", [this](std::size_t i) { return bounded_[i]; });
        text += each("KEEP(n{0}, b{0} + at);", [this](std::size_t i) { return !traits_.idle(i); });
        const std::string last = each("KEEP(n{0}, b{0} + at);", [this](std::size_t i) { return traits_.idle(i); });
        if (!last.empty()) text += fmt::format("if (step + 1 == steps) {{\n{}}}\n", last);
        if (traits_.writes_rates()) text += each("KEEP(q{0}, f{0} + at);", all(&LatticeTraits::per_cell));
        for (const std::size_t i : use_.mappings_written) text += fmt::format("KEEP(m{0}, map{0} + at);\n", i);
        if (traits_.turns()) {
            text += traits_.turn(precision_) + "KEEP(turned_x, new_px + at);\nKEEP(turned_y, new_py + at);\n";
        }
        return text + each("ROLL_ON({0})", all(&LatticeTraits::rolled));
    }

    const Experiment& experiment_;
    const LatticePlan& plan_;
    const RuleUse& use_;
    LatticeTraits traits_;
    const std::vector<bool>& bounded_;
    Precision precision_;
    bool means_;
    std::vector<std::size_t> rate_planes_;
};

}  // namespace

std::string neighbours_text(const std::string& visit, bool volume) {
    return Source().file(volume ? "volume/neighbours.cl" : "lattice/neighbours.cl", {{"visit", visit}}).str();
}

std::vector<std::size_t> rate_planes(const LatticePlan& plan) {
    std::vector<std::size_t> places;
    std::size_t next = 0;
    for (const RateKind kind : plan.rates) places.push_back(kind == RateKind::per_cell ? next++ : no_plane);
    return places;
}

std::size_t own_rates(const LatticePlan& plan) {
    return static_cast<std::size_t>(std::ranges::count(plan.rates, RateKind::per_cell));
}

std::string lattice_settings(const LatticePlan& plan, std::size_t width) {
    std::string text = fmt::format("#define PELAGE_WIDTH {}\n#define {}\n#define {}\n", width,
                                   boundary_word(plan.boundary), stencil_word(plan.stencil));
    if (plan.reach() > 1) text += fmt::format("#define PELAGE_REACH {}\n", plan.reach());
    if (plan.arithmetic == Arithmetic::published) text += "#define PELAGE_PUBLISHED\n";
    return text;
}

std::string emit_parameters(const LatticePlan& plan, const std::vector<bool>& bounded, const Numbers& numbers) {
    std::string text;
    for (std::size_t i = 0; i < plan.rates.size(); ++i) {
        const auto read = [&](const char* name, LatticeParameter what) {
            text += fmt::format("const real {}{} = R(parameters[{}]);\n", name, i, parameter_place(i, what));
        };
        if (bounded[i]) read("floor", LatticeParameter::floor);
        if (bounded[i]) read("limit", LatticeParameter::limit);
        if (plan.rates[i] == RateKind::per_cell) continue;
        read("r", LatticeParameter::rate);
        if (plan.rates[i] == RateKind::uniform && plan.arithmetic == Arithmetic::fused) {
            read("share", LatticeParameter::share);
        }
    }
    return text + numbers.declarations(parameter_place(plan.rates.size(), LatticeParameter::floor));
}

std::vector<bool> bounded_chemicals(const Experiment& experiment) {
    std::vector<bool> bounded(experiment.chemicals.size());
    for (const Phase& phase : experiment.phases) {
        for (std::size_t i = 0; i < bounded.size(); ++i) {
            const Bounds& bounds = phase.bounds[i];
            bounded[i] = bounded[i] || std::isfinite(bounds.floor) || std::isfinite(bounds.limit);
        }
    }
    return bounded;
}

double stencil_divisor(Stencil stencil) {
    if (stencil == Stencil::twenty_seven_point) return 30.0;
    return stencil == Stencil::nine_point ? 6.0 : stencil == Stencil::sims ? 20.0 : 1.0;
}

std::string lattice_source(const Experiment& experiment, const LatticePlan& plan, const RuleText& rules,
                           const std::vector<bool>& bounded, Precision precision, std::size_t width, bool together,
                           bool means, bool batch) {
    const LatticeEmitter emitter(experiment, plan, rules.use, bounded, precision, means);
    Source source;
    source.text(emitter.settings(width)).file("common/prelude.cl").file("rules/philox.cl").file("lattice/rows.cl");
    source.file(plan.volume() ? "volume/stencil.cl" : "lattice/stencil.cl");
    source.file("common/exchange.cl").file("lattice/exchange.cl");
    if (together) source.text("#define PELAGE_TOGETHER").file("lattice/together.cl");
    if (batch) source.text("#define PELAGE_BATCH");
    for (const std::string& file : rule_files(rules.use)) source.file(file);
    std::map<std::string, std::string> fills = emitter.fills(rules);
    if (plan.volume()) return source.file("volume/step.cl", fills).str();
    fills["batch"] = batch ? batch_text(experiment, plan, rules, {"mapping"}) : "";
    return source.file("lattice/step.cl", fills).str();
}

}  // namespace pelage
