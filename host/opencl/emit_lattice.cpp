// See emit_lattice.hpp. The fragments fill the //@ lines of kernels/lattice.cl; for chemical i they name
//   a<i>, b<i>  planes of old and new concentrations     c<i>, n<i>  the cell's values
//   d<i>, f<i>  planes of old and new rates              r<i>, q<i>  the cell's values
#include "opencl/emit_lattice.hpp"

#include "opencl/program.hpp"

#include <fmt/format.h>

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
    }
    return "";
}

double neighbour_share(Stencil stencil, bool diagonal) {
    switch (stencil) {
        case Stencil::nine_point:
            return diagonal ? 1.0 / 6 : 4.0 / 6;
        case Stencil::sims:
            return diagonal ? 0.05 : 0.2;
        default:
            return 1.0;
    }
}

class LatticeEmitter {
public:
    LatticeEmitter(const Experiment& experiment, const LatticePlan& plan, const RuleUse& use,
                   const std::vector<bool>& bounded, Precision precision)
        : experiment_(experiment),
          plan_(plan),
          use_(use),
          bounded_(bounded),
          precision_(precision),
          rate_planes_(rate_planes(plan)) {
        for (std::size_t i = 0; i < plan.rates.size(); ++i) polarity_ = polarity_ || directed(i);
        polarity_ = polarity_ || !use.polarizes.empty();
    }

    std::map<std::string, std::string> fills(const RuleText& text) const {
        return {{"parameters", emit_parameters(plan_, bounded_)},
                {"planes", planes()},
                {"start", start()},
                {"cell", cell()},
                {"rules", text.rules},
                {"visit", visit()},
                {"replace", text.replace},
                {"finish", finish()},
                {"diffusion", diffusion()},
                {"swap", swap()}};
    }

    std::string settings(std::size_t width) const {
        std::string text = lattice_settings(plan_, width);
        if (visits()) text += "#define PELAGE_VISITS\n";
        text += fmt::format("#define EDGE_SHARE {}\n#define DIAGONAL_SHARE {}\n",
                            emit_number(neighbour_share(plan_.stencil, false), precision_),
                            emit_number(neighbour_share(plan_.stencil, true), precision_));
        return text;
    }

private:
    bool per_cell(std::size_t i) const { return plan_.rates[i] == RateKind::per_cell; }
    bool directed(std::size_t i) const { return per_cell(i) && plan_.polarity && experiment_.chemicals[i].anisotropic; }
    bool rolled(std::size_t i) const {
        return plan_.rates[i] == RateKind::uniform && plan_.arithmetic == Arithmetic::fused;
    }
    bool visited(std::size_t i) const { return plan_.rates[i] != RateKind::none && !rolled(i); }
    bool writes_rates() const { return !use_.rates_written.empty(); }
    bool visits() const {
        bool any = !use_.polarizes.empty();
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) any = any || visited(i);
        return any;
    }

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
    auto all(bool (LatticeEmitter::*is)(std::size_t) const) const {
        return [this, is](std::size_t i) { return (this->*is)(i); };
    }

    std::string planes() const {
        std::string text = each(
            "global scalar* const a{0} = PLANE(old_conc, {0});\n"
            "global scalar* const b{0} = PLANE(new_conc, {0});");
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            if (!per_cell(i)) continue;
            text += fmt::format("global scalar* const d{} = PLANE(old_rate, {});\n", i, rate_planes_[i]);
            if (writes_rates())
                text += fmt::format("global scalar* const f{} = PLANE(new_rate, {});\n", i, rate_planes_[i]);
        }
        for (std::size_t i = 0; i < experiment_.mappings.size(); ++i) {
            if (maps(i)) text += fmt::format("global scalar* const map{0} = PLANE(mapping, {0});\n", i);
        }
        if (polarity_) {
            text +=
                "global scalar* const old_px = PLANE(old_polarity, 0);\n"
                "global scalar* const old_py = PLANE(old_polarity, 1);\n";
        }
        if (!use_.polarizes.empty()) {
            text +=
                "global scalar* const new_px = PLANE(new_polarity, 0);\n"
                "global scalar* const new_py = PLANE(new_polarity, 1);\n";
        }
        return text;
    }

    bool maps(std::size_t i) const { return use_.mappings_read.contains(i) || use_.mappings_written.contains(i); }

    std::string start() const { return each("ROLL_START({0}, low)", all(&LatticeEmitter::rolled)); }

    std::string cell() const {
        std::string text = each("ROLL_AHEAD({0}, row)", all(&LatticeEmitter::rolled));
        text += each("const real c{0} = LOAD(a{0} + at);", [this](std::size_t i) { return !rolled(i); });
        text += each("real n{0} = c{0};");
        text += each("const real r{0} = LOAD(d{0} + at);", all(&LatticeEmitter::per_cell));
        if (writes_rates()) text += each("real q{0} = r{0};", all(&LatticeEmitter::per_cell));
        for (std::size_t i = 0; i < experiment_.mappings.size(); ++i) {
            if (maps(i)) text += fmt::format("real m{0} = LOAD(map{0} + at);\n", i);
        }
        if (polarity_) text += "const real px = LOAD(old_px + at);\nconst real py = LOAD(old_py + at);\n";
        for (const std::size_t i : use_.polarizes) text += fmt::format("real gx{0} = R(0);\nreal gy{0} = R(0);\n", i);
        return text;
    }

    std::string diffusion() const { return each("ROLL_DIFFUSE({0})", all(&LatticeEmitter::rolled)); }

    std::string visit() const {
        std::string text;
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            if (!visited(i)) continue;
            text += fmt::format("EXCHANGE_{}({})\n",
                                directed(i)   ? "DIRECTED"
                                : per_cell(i) ? "PER_CELL"
                                              : "UNIFORM",
                                i);
        }
        for (const std::size_t i : use_.polarizes) text += fmt::format("GRADIENT({})\n", i);
        return text;
    }

    std::string finish() const {
        std::string text = each("n{0} = SELECT(n{0} < floor{0}, floor{0}, SELECT(n{0} > limit{0}, limit{0}, n{0}));",
                                [this](std::size_t i) { return bounded_[i]; });
        text += each("KEEP(n{0}, b{0} + at);");
        if (writes_rates()) text += each("KEEP(q{0}, f{0} + at);", all(&LatticeEmitter::per_cell));
        for (const std::size_t i : use_.mappings_written) text += fmt::format("KEEP(m{0}, map{0} + at);\n", i);
        if (!use_.polarizes.empty()) text += turn();
        return text + each("ROLL_ON({0})", all(&LatticeEmitter::rolled));
    }

    // Polarity becomes the unit gradient where that is steep enough.
    std::string turn() const {
        std::string any = "ALL_FALSE", gx = "R(0)", gy = "R(0)";
        for (const std::size_t i : use_.polarizes) {
            any = fmt::format("{} | g{}", any, i);
            gx = fmt::format("SELECT(g{0}, gx{0}, {1})", i, gx);
            gy = fmt::format("SELECT(g{0}, gy{0}, {1})", i, gy);
        }
        return fmt::format(
            "const real gx = {};\nconst real gy = {};\nconst real slope = sqrt(gx * gx + gy * gy);\n"
            "const mask steep = ({}) & (slope > {});\n"
            "KEEP(SELECT(steep, gx / slope, px), new_px + at);\nKEEP(SELECT(steep, gy / slope, py), new_py + at);\n",
            gx, gy, any, emit_number(0.0001, precision_));
    }

    std::string swap() const {
        std::string text = "SWAP(old_conc, new_conc)\n";
        if (writes_rates()) text += "SWAP(old_rate, new_rate)\n";
        if (!use_.polarizes.empty()) text += "SWAP(old_polarity, new_polarity)\n";
        return text;
    }

    const Experiment& experiment_;
    const LatticePlan& plan_;
    const RuleUse& use_;
    const std::vector<bool>& bounded_;
    Precision precision_;
    std::vector<std::size_t> rate_planes_;
    bool polarity_ = false;
};

}  // namespace

std::vector<std::size_t> rate_planes(const LatticePlan& plan) {
    std::vector<std::size_t> places;
    std::size_t next = 0;
    for (const RateKind kind : plan.rates) places.push_back(kind == RateKind::per_cell ? next++ : no_plane);
    return places;
}

std::string lattice_settings(const LatticePlan& plan, std::size_t width) {
    std::string text = fmt::format("#define PELAGE_WIDTH {}\n#define {}\n#define {}\n", width,
                                   boundary_word(plan.boundary), stencil_word(plan.stencil));
    if (plan.arithmetic == Arithmetic::published) text += "#define PELAGE_PUBLISHED\n";
    return text;
}

std::string emit_parameters(const LatticePlan& plan, const std::vector<bool>& bounded) {
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
    return text;
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
    return stencil == Stencil::nine_point ? 6.0 : stencil == Stencil::sims ? 20.0 : 1.0;
}

std::string lattice_source(const Experiment& experiment, const LatticePlan& plan, const RuleText& rules,
                           const std::vector<bool>& bounded, Precision precision, std::size_t width) {
    const LatticeEmitter emitter(experiment, plan, rules.use, bounded, precision);
    Source source;
    source.text(emitter.settings(width))
        .file("prelude.cl")
        .file("philox.cl")
        .file("lattice_rows.cl")
        .file("stencil.cl");
    source.file("exchange.cl");
    for (const std::string& model : model_files(rules.use)) source.file(model);
    return source.file("lattice.cl", emitter.fills(rules)).str();
}

}  // namespace pelage
