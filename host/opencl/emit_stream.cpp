// See emit_stream.hpp. Names of values are those of emit_lattice.cpp.
#include "opencl/emit_stream.hpp"

#include "opencl/emit_lattice.hpp"
#include "opencl/program.hpp"

#include <fmt/format.h>

#include <map>

namespace pelage {

std::string why_not_fused(const LatticePlan& plan, const RuleUse& use) {
    if (plan.arithmetic != Arithmetic::fused) return "a sqr_grid keeps the published order of operations";
    for (const RateKind kind : plan.rates) {
        if (kind == RateKind::per_cell) return "diffusion rates differ between cells";
    }
    if (!use.rates_written.empty()) return "rules write diffusion rates";
    if (!use.mappings_read.empty() || !use.mappings_written.empty()) return "mappings outlast an iteration";
    if (!use.polarizes.empty() || use.polarity) return "rules turn or read polarities";
    for (const Quantity kept : {Quantity::neighbours, Quantity::age, Quantity::birth}) {
        if (use.quantities.contains(kept)) return "rules read NEIGHBORS, AGE or BIRTH";
    }
    return "";
}

namespace {

class StreamEmitter {
public:
    StreamEmitter(const LatticePlan& plan, const RuleUse& use, const std::vector<bool>& bounded)
        : plan_(plan), use_(use), bounded_(bounded) {}

    std::map<std::string, std::string> fills(const RuleText& text) const {
        return {{"parameters", emit_parameters(plan_, bounded_)},
                {"planes", planes()},
                {"fetch", fetch()},
                {"resume", resume()},
                {"suspend", suspend()},
                {"row", row()},
                {"cell", cell()},
                {"rules", text.rules},
                {"diffusion", diffusion()},
                {"replace", text.replace},
                {"finish", finish()},
                {"put", put()},
                {"unroll", unroll(text)}};
    }

    std::size_t carried() const {
        std::size_t vectors = 0;
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) vectors += rolled(i) ? 3 : 1;
        return vectors;
    }

private:
    bool rolled(std::size_t i) const { return plan_.rates[i] == RateKind::uniform; }
    bool reads(Quantity quantity) const { return use_.quantities.contains(quantity); }
    bool absorbing() const { return plan_.boundary == Boundary::absorbing; }

    // The formats, with {0} the chemical and {1} the first vector it carries: one for those that diffuse, one for
    // others.
    std::string each(const char* diffusing, const char* still) const {
        std::string text;
        std::size_t place = 0;
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            text += fmt::format(fmt::runtime(rolled(i) ? diffusing : still), i, place, place + 1, place + 2);
            place += rolled(i) ? 3 : 1;
        }
        return text;
    }
    std::string each(const char* format) const { return each(format, format); }

    std::string planes() const {
        return each(
            "global const scalar* const a{0} = PLANE(old_conc, {0});\n"
            "global scalar* const b{0} = PLANE(new_conc, {0});\n");
    }
    std::string fetch() const {
        return each("STORE(pelage_fetch(a{0} + there, x, columns), SCRATCH(0, r, {0}) + c * PELAGE_WIDTH);\n");
    }
    std::string put() const {
        return each("pelage_put(LOAD(SCRATCH(steps & 1, r, {0}) + c * PELAGE_WIDTH), b{0} + there, x, from, to);\n");
    }

    std::string resume() const {
        std::string text = each(
            "real below{0} = LOAD(CARRY({1}));\nreal own{0} = LOAD(CARRY({2}));\n"
            "real c{0} = LOAD(CARRY({3}));\n",
            "real c{0} = LOAD(CARRY({1}));\n");
        if (use_.random || reads(Quantity::column)) text += "const uintv column = pelage_columns(x, columns);\n";
        if (absorbing()) {
            text += "const mask inside_columns = TO_MASK((LANES + (uintv)((uint)x)) < (uintv)((uint)columns));\n";
        }
        return text;
    }
    std::string suspend() const {
        return each("STORE(below{0}, CARRY({1}));\nSTORE(own{0}, CARRY({2}));\nSTORE(c{0}, CARRY({3}));\n",
                    "STORE(c{0}, CARRY({1}));\n");
    }

    std::string row() const {
        std::string text;
        if (use_.random || reads(Quantity::row) || reads(Quantity::y)) {
            text += "const int row = pelage_stands_for(base + r - level - 1, rows, 0);\n";
        }
        if (use_.random) text += "const uintv id = (uintv)((uint)row * (uint)columns) + column;\n";
        return text;
    }

    std::string cell() const {
        return each("TAKE({0})\nTAKE_SUM({0})\nreal n{0} = c{0};\n", "TAKE({0})\nreal n{0} = c{0};\n");
    }
    // Long rules would only make compilation slow.
    static std::string unroll(const RuleText& text) { return text.rules.size() < 1000 ? "#pragma unroll\n" : ""; }

    std::string diffusion() const { return each("ROLL_DIFFUSE({0})\n", ""); }

    std::string finish() const {
        std::string text;
        for (std::size_t i = 0; i < bounded_.size(); ++i) {
            if (!bounded_[i]) continue;
            text +=
                fmt::format("n{0} = SELECT(n{0} < floor{0}, floor{0}, SELECT(n{0} > limit{0}, limit{0}, n{0}));\n", i);
        }
        if (absorbing()) {
            text +=
                "const int at_row = base + r - level - 1;\n"
                "const mask inside = UNIFORM(at_row >= 0 && at_row < rows) & inside_columns;\n";
            text += each("n{0} = SELECT(inside, n{0}, R(0));\n");
        }
        text += each("STORE(n{0}, result + {0} * SLOT);\n");
        return text + each("ROLL_ON({0})\n", "c{0} = up{0};\n");
    }

    const LatticePlan& plan_;
    const RuleUse& use_;
    const std::vector<bool>& bounded_;
};

}  // namespace

std::string stream_source(const Experiment& experiment, const LatticePlan& plan, const RuleText& rules,
                          const std::vector<bool>& bounded, std::size_t width, const StreamShape& shape) {
    const StreamEmitter emitter(plan, rules.use, bounded);
    Source source;
    source.text(lattice_settings(plan, width));
    source.text(fmt::format(
        "#define PELAGE_DEPTH {}\n#define PELAGE_BLOCK {}\n#define PELAGE_VECTORS {}\n"
        "#define PELAGE_GROUP {}\n#define PELAGE_FIELDS {}\n#define PELAGE_CARRIED {}\n",
        shape.depth, shape.block, shape.vectors, shape.group, experiment.chemicals.size(), emitter.carried()));
    source.file("prelude.cl").file("philox.cl").file("lattice_rows.cl").file("stencil.cl");
    for (const std::string& model : model_files(rules.use)) source.file(model);
    return source.file("lattice_stream.cl", emitter.fills(rules)).str();
}

}  // namespace pelage
