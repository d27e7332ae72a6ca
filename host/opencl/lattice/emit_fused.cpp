// See emit_fused.hpp. Names of values are those of emit_lattice.cpp; beyond them, for field f of what passes through,
//   from<f>, to<f>  planes that it comes from and goes to
#include "opencl/lattice/emit_fused.hpp"

#include "opencl/device/program.hpp"
#include "opencl/lattice/emit_batch.hpp"
#include "opencl/lattice/emit_lattice.hpp"
#include "opencl/lattice/passing.hpp"
#include "opencl/lattice/traits.hpp"

#include <fmt/format.h>

#include <map>

namespace pelage {

namespace {

class FusedEmitter {
public:
    FusedEmitter(const Experiment& experiment, const LatticePlan& plan, const RuleUse& use,
                 const std::vector<bool>& bounded, Precision precision)
        : plan_(plan),
          use_(use),
          bounded_(bounded),
          precision_(precision),
          traits_(experiment, plan, use),
          fields_(passing_fields(experiment, plan, use)) {}

    // Of kernels/lattice/tile.cl.
    std::map<std::string, std::string> fills(const RuleText& text) const {
        return {{"parameters", emit_parameters(plan_, bounded_, text.numbers)},
                {"planes", planes()},
                {"fetch", fetch()},
                {"resume", resume()},
                {"row", row()},
                {"cell", cell()},
                {"shared", text.shared},
                {"rules", traits_.look() + text.rules},
                {"diffusion", diffusion()},
                {"neighbours", traits_.visits() ? neighbours_text(traits_.visit()) : ""},
                {"replace", text.replace},
                {"finish", finish()},
                {"put", put()}};
    }

    // Of kernels/lattice/stream.cl.
    std::map<std::string, std::string> stream_fills(const RuleText& text) const {
        std::map<std::string, std::string> all = fills(text);
        all.insert({{"prefetch", prefetch()}, {"suspend", suspend()}, {"unroll", unroll(text)}});
        return all;
    }

    std::string settings() const {
        std::string text = fmt::format("#define PELAGE_FIELDS {}\n#define PELAGE_SEEN {}\n#define PELAGE_CARRIED {}\n",
                                       fields_.size(), count_seen(fields_), carried());
        if (traits_.visits()) text += "#define PELAGE_VISITS\n" + traits_.shares(precision_);
        return text;
    }

private:
    bool reads(Quantity quantity) const { return use_.quantities.contains(quantity); }
    bool absorbing() const { return plan_.boundary == Boundary::absorbing; }

    // Vectors that a level carries along of a field.
    std::size_t carried(const Passing& field) const {
        if (field.buffer == "conc" && traits_.rolled(field.plane)) return 3;
        return field.middle.empty() ? 1 : 0;
    }
    std::size_t carried() const {
        std::size_t vectors = 0;
        for (const Passing& field : fields_) vectors += carried(field);
        return vectors;
    }

    // The format for every field: {0} its number, {1} the number of what it is of, {2} the first vector carried,
    // {3} the value handed on.
    using Formats = const char* (*)(const Passing&, std::size_t carried);
    std::string each(Formats format_of) const {
        std::string text;
        std::size_t place = 0;
        for (std::size_t f = 0; f < fields_.size(); ++f) {
            const std::size_t vectors = carried(fields_[f]);
            text += fmt::format(fmt::runtime(format_of(fields_[f], vectors)), f, fields_[f].plane, place,
                                fields_[f].result);
            place += vectors;
        }
        return text;
    }

    // The format for every chemical that is idle.
    std::string idle(const char* format, const char* bounded) const {
        std::string text;
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            if (traits_.idle(i)) text += fmt::format(fmt::runtime(bounded_[i] ? bounded : format), i);
        }
        return text;
    }

    std::string planes() const {
        std::string text;
        for (std::size_t f = 0; f < fields_.size(); ++f) {
            const Passing& field = fields_[f];
            text +=
                fmt::format("global const scalar* const from{0} = PLANE(pass % 2 == 0 ? even_{1} : odd_{1}, {2});\n", f,
                            field.buffer, field.plane);
            if (!field.written) continue;
            text += fmt::format("global scalar* const to{0} = PLANE(pass % 2 == 0 ? odd_{1} : even_{1}, {2});\n", f,
                                field.buffer, field.plane);
        }
        for (const std::size_t i : use_.fields)
            text += fmt::format("global const scalar* const field{0} = PLANE(fields, {0});\n", i);
        const char* const both =
            "global const scalar* const idle{0} = PLANE(even_conc, {0});\n"
            "global scalar* const rest{0} = PLANE(pass % 2 == 0 ? odd_conc : even_conc, {0});\n";
        return text + idle(both, both);
    }

    std::string fetch() const {
        return each([](const Passing&, std::size_t) {
            return "STORE(pelage_fetch(from{0} + there, x, columns), SCRATCH(0, r, {0}) + c * PELAGE_WIDTH);\n";
        });
    }
    std::string prefetch() const {
        return each([](const Passing&, std::size_t) {
            return "__builtin_prefetch((const void*)(size_t)(from{0} + there + x));\n";
        });
    }
    std::string put() const {
        std::string text = each([](const Passing& field, std::size_t) {
            return field.written ? "pelage_put(LOAD(SCRATCH(steps & 1, r, {0}) + c * PELAGE_WIDTH), to{0} + there, x, "
                                   "from, to);\n"
                                 : "";
        });
        const std::string rest =
            idle("pelage_put(pelage_fetch(idle{0} + there, x, columns), rest{0} + there, x, from, to);\n",
                 "pelage_put(HELD(pelage_fetch(idle{0} + there, x, columns), floor{0}, limit{0}), rest{0} + there, x, "
                 "from, to);\n");
        return rest.empty() ? text : text + "if (pass + 1 == passes) {\n" + rest + "}\n";
    }

    std::string resume() const {
        std::string text = each([](const Passing& field, std::size_t vectors) {
            if (vectors == 3) return "RESUME_SUMS({1}, {0}, {2})\n";
            if (vectors == 0) return "";
            return field.buffer == "conc" ? "RESUME(c{1}, {0}, {2})\n" : "RESUME(kept{1}, {0}, {2})\n";
        });
        if (use_.random || reads(Quantity::column) || traits_.visits()) {
            text += "const uintv column = pelage_columns(x, columns);\n";
        }
        if (reads(Quantity::x)) text += "const real place_x = pelage_gather(places, x, columns);\n";
        if (absorbing() || traits_.visits()) {
            text += "const mask inside_columns = TO_MASK((LANES + (uintv)((uint)x)) < (uintv)((uint)columns));\n";
        }
        if (traits_.visits()) {
            text += "const mask mirrored = !inside_columns;\nconst int edge = x < 0 || x + PELAGE_WIDTH > columns;\n";
        }
        return text;
    }
    std::string suspend() const {
        return each([](const Passing& field, std::size_t vectors) {
            if (vectors == 3) return "SUSPEND_SUMS({1}, {2})\n";
            if (vectors == 0) return "";
            return field.buffer == "conc" ? "SUSPEND(c{1}, {2})\n" : "SUSPEND(kept{1}, {2})\n";
        });
    }

    std::string row() const {
        std::string text = "const int at_row = AT_ROW;\n";
        bool wanted = use_.random || traits_.visits();
        for (const Quantity of_place :
             {Quantity::row, Quantity::y, Quantity::neighbours, Quantity::birth, Quantity::age}) {
            wanted = wanted || reads(of_place);
        }
        for (const std::size_t i : use_.concentrations_read) wanted = wanted || traits_.idle(i);
        wanted = wanted || !use_.fields.empty();
        if (wanted) text += "const int row = pelage_stands_for(at_row, rows, 0);\n";
        if (use_.random) text += "const uintv id = (uintv)((uint)row * (uint)columns) + column;\n";
        return text;
    }

    std::string cell() const {
        std::string text;
        for (std::size_t f = 0; f < fields_.size(); ++f) {
            if (fields_[f].middle.empty()) continue;
            text += fmt::format("local const scalar* const {} = SCRATCH(level & 1, MIDDLE, {}) + c * PELAGE_WIDTH;\n",
                                fields_[f].middle, f);
        }
        text += each([](const Passing& field, std::size_t vectors) {
            if (field.buffer == "mapping")
                return "const real next{1} = LOAD(above + {0} * SLOT);\nreal m{1} = kept{1};\n";
            if (field.buffer == "rate") return "";
            if (field.buffer == "polarity") {
                return field.plane == 0 ? "const real px = LOAD(old_px);\n" : "const real py = LOAD(old_py);\n";
            }
            if (vectors == 3) return "TAKE({1}, {0})\nTAKE_SUM({1}, {0})\nreal n{1} = c{1};\n";
            if (vectors == 1) return "TAKE({1}, {0})\nreal n{1} = c{1};\n";
            return "const real c{1} = LOAD(a{1});\nreal n{1} = c{1};\n";
        });
        for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
            if (traits_.per_cell(i)) text += fmt::format("const real r{0} = LOAD(d{0});\n", i);
            if (traits_.per_cell(i) && traits_.writes_rates()) text += fmt::format("real q{0} = r{0};\n", i);
            if (traits_.idle(i) && use_.concentrations_read.contains(i)) text += idle_value(i);
        }
        for (const std::size_t i : use_.fields)
            text += fmt::format("const real z{0} = pelage_fetch(field{0} + (long)row * pitch, x, columns);\n", i);
        for (const std::size_t i : use_.polarizes) text += fmt::format("real gx{0} = R(0);\nreal gy{0} = R(0);\n", i);
        return text;
    }
    std::string idle_value(std::size_t i) const {
        std::string text = fmt::format("real c{0} = pelage_fetch(idle{0} + (long)row * pitch, x, columns);\n", i);
        if (bounded_[i]) text += fmt::format("if (step > 0) c{0} = HELD(c{0}, floor{0}, limit{0});\n", i);
        return text;
    }

    // Long rows would only make compilation slow. A number counts as what it would be in full.
    std::string unroll(const RuleText& text) const {
        return text.rules.size() + 14 * text.numbers.declared() < 1000 && !traits_.visits() ? "#pragma unroll\n" : "";
    }

    std::string diffusion() const {
        return each([](const Passing&, std::size_t vectors) { return vectors == 3 ? "ROLL_DIFFUSE({1})\n" : ""; });
    }

    std::string finish() const {
        std::string text;
        for (std::size_t i = 0; i < bounded_.size(); ++i) {
            if (bounded_[i] && !traits_.idle(i)) text += fmt::format("n{0} = HELD(n{0}, floor{0}, limit{0});\n", i);
        }
        if (traits_.turns()) text += traits_.turn(precision_);
        if (absorbing()) {
            text += "const mask present = UNIFORM(at_row >= 0 && at_row < rows) & inside_columns;\n";
            text += each([](const Passing& field, std::size_t) {
                return field.buffer == "conc" ? "n{1} = SELECT(present, n{1}, R(0));\n" : "";
            });
        }
        text += each([](const Passing&, std::size_t) { return "STORE({3}, result + {0} * SLOT);\n"; });
        return text + each([](const Passing& field, std::size_t vectors) {
                   if (vectors == 3) return "ROLL_ON({1})\n";
                   if (vectors == 0) return "";
                   return field.buffer == "conc" ? "c{1} = up{1};\n" : "kept{1} = next{1};\n";
               });
    }

    const LatticePlan& plan_;
    const RuleUse& use_;
    const std::vector<bool>& bounded_;
    Precision precision_;
    LatticeTraits traits_;
    std::vector<Passing> fields_;
};

// All but the kernel itself.
Source library(const LatticePlan& plan, const RuleUse& use, const FusedEmitter& emitter, std::size_t width,
               const std::string& shape) {
    Source source;
    source.text(lattice_settings(plan, width) + emitter.settings()).text(shape);
    source.file("common/prelude.cl").file("rules/philox.cl").file("lattice/rows.cl").file("lattice/stencil.cl");
    source.file("lattice/mirrors.cl").file("common/exchange.cl").file("lattice/exchange.cl").file("lattice/margins.cl");
    for (const std::string& file : rule_files(use)) source.file(file);
    return source;
}

}  // namespace

std::string stream_source(const Experiment& experiment, const LatticePlan& plan, const RuleText& rules,
                          const std::vector<bool>& bounded, Precision precision, std::size_t width,
                          const FusedShape& shape) {
    const FusedEmitter emitter(experiment, plan, rules.use, bounded, precision);
    const std::string settings = fmt::format(
        "#define PELAGE_DEPTH {}\n#define PELAGE_BLOCK {}\n#define PELAGE_VECTORS {}\n#define PELAGE_GROUP {}\n{}{}",
        shape.depth, shape.rows, shape.vectors, shape.group, shape.prefetch ? "#define PELAGE_PREFETCH\n" : "",
        shape.together ? "#define PELAGE_TOGETHER\n" : "");
    Source source = library(plan, rules.use, emitter, width, settings);
    if (shape.together) source.file("lattice/together.cl");
    return source.file("lattice/stream.cl", emitter.stream_fills(rules)).str();
}

std::string tile_source(const Experiment& experiment, const LatticePlan& plan, const RuleText& rules,
                        const std::vector<bool>& bounded, Precision precision, std::size_t width,
                        const FusedShape& shape) {
    const FusedEmitter emitter(experiment, plan, rules.use, bounded, precision);
    const std::string settings = fmt::format(
        "#define PELAGE_DEPTH {}\n#define PELAGE_TALL {}\n#define PELAGE_VECTORS {}\n#define PELAGE_GROUP {}\n{}",
        shape.depth, shape.rows + 2 * shape.depth, shape.vectors, shape.group,
        shape.batch ? "#define PELAGE_BATCH\n" : "");
    std::map<std::string, std::string> fills = emitter.fills(rules);
    fills["batch"] = shape.batch ? batch_text(experiment, plan, rules, {"even_mapping", "odd_mapping"}) : "";
    return library(plan, rules.use, emitter, width, settings).file("lattice/tile.cl", fills).str();
}

}  // namespace pelage
