// Lints of what is described and not needed: chemicals, mappings, colours, pictures.
#include "core/aggregate.hpp"
#include "language/expression.hpp"
#include "language/lints.hpp"
#include "language/pieces.hpp"
#include "language/previous.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace pelage::language {

namespace {

// What rules, starts, fields and pictures touch.
class Uses {
public:
    explicit Uses(const Experiment& experiment) : experiment_(experiment) {
        for (const Rule& rule : experiment.rules) {
            std::visit([&](const auto& condition) { look(condition); }, rule.condition);
            std::visit([&](const auto& action) { look(action); }, rule.action);
        }
        for (const Statement& statement : experiment.prepattern) {
            std::visit([&](const auto& start) { look(start); }, statement);
        }
        for (const PlaceField& field : experiment.fields) {
            const auto* computed = std::get_if<ComputedField>(&field.source);
            if (computed != nullptr) read(computed->expression);
        }
        for (const Output& output : experiment.outputs) {
            if (output.expressions.empty()) chemicals.insert(output.chemical);
            for (const Expression& expression : output.expressions) read(expression);
        }
    }
    std::set<std::size_t> chemicals;
    std::set<std::size_t> mappings;  // that are read
    std::set<std::size_t> fields;
    std::set<std::size_t> stencils;

private:
    void read(const Expression& expression) {
        each_operand(expression, [&](const Operand& part) { read(part); });
    }
    void read(const Operand& operand) {
        switch (operand.quantity) {
            case Quantity::expression:
                return read(experiment_.expressions[operand.index]);
            case Quantity::mapping:
                mappings.insert(operand.index);
                return;
            case Quantity::field:
                fields.insert(operand.index);
                return;
            case Quantity::concentration:
            case Quantity::rate:
            case Quantity::laplacian:
            case Quantity::gradient_x:
            case Quantity::gradient_y:
                chemicals.insert(operand.index);
                return;
            case Quantity::stencil:
                stencils.insert(operand.stencil);
                chemicals.insert(operand.index);
                return;
            default:
                return;
        }
    }
    void read(const std::optional<Spread>& spread) {
        if (spread && spread->expression) read(experiment_.expressions[*spread->expression]);
    }
    void look(const UseChemical& use) {
        read(use.conc);
        read(use.diff);
    }
    void look(const SetCells& set) {
        if (set.where) read(experiment_.expressions[*set.where]);
        if (const auto* conc = std::get_if<SetConcentration>(&set.what)) read(conc->value);
        if (const auto* diff = std::get_if<SetRate>(&set.what)) read(diff->value);
    }
    void look(const UsePolarity&) {}
    void look(const UseSeed&) {}
    void look(const CreateCell&) {}
    void look(const CreateGrid&) {}
    void look(const CreateMatrix&) {}
    void look(const CreateVolume&) {}
    void look(const CreateMesh&) {}
    void look(const CreateShape&) {}
    void look(const Always&) {}
    void look(const Compare& compare) {
        read(compare.left);
        read(compare.right);
    }
    void look(const Within& within) {
        read(within.value);
        read(within.low);
        read(within.high);
    }
    void look(const Probability& probability) { read(probability.chance); }
    void look(const React& react) {
        chemicals.insert(react.species.begin(), react.species.end());
        read(react.scale);
        for (const Operand& parameter : react.parameters) read(parameter);
    }
    void look(const Formula& formula) {
        for (const Formula::Part& part : formula.parts) {
            chemicals.insert(part.chemical);
            read(part.rate);
        }
    }
    void look(const Neural& neural) {
        chemicals.insert(neural.species.begin(), neural.species.end());
        read(neural.rate);
        read(neural.diffusion);
    }
    void look(const Change& change) {
        chemicals.insert(change.chemical);
        read(change.amount);
    }
    void look(const Set& set) {
        chemicals.insert(set.chemical);
        read(set.value);
    }
    void look(const Map& map) { read(map.value); }
    void look(const Polarize& polarize) { chemicals.insert(polarize.chemical); }
    void look(const Divide& divide) { read(divide.direction); }
    void look(const Move& move) { read(move.distance); }
    void look(const And&) {}
    void look(const Expand&) {}
    void look(const Aggregate& aggregate) {
        chemicals.insert({aggregate.order, aggregate.potential});
        if (aggregate.seed) chemicals.insert(*aggregate.seed);
        if (aggregate.size) chemicals.insert(*aggregate.size);
        read(aggregate.grown);
        each_parameter(aggregate, [&](const Operand& parameter) { read(parameter); });
    }

    const Experiment& experiment_;
};

bool equal(const Colormap& one, const Colormap& other) {
    const auto same = [](const ColourStop& a, const ColourStop& b) {
        const auto& [at, rgb] = a;
        return at == b.at && rgb == b.rgb;
    };
    const auto& [name, stops] = one;
    return name == other.name && std::ranges::equal(stops, other.stops, same);
}

bool equal(const std::optional<Projection>& one, const std::optional<Projection>& other) {
    if (!one || !other) return !one && !other;
    const auto& [kind, axis, at] = *one;
    return kind == other->kind && axis == other->axis && at == other->at;
}

// A member that is added one day makes this line wrong, and so cannot be forgotten.
bool equal(const Output& one, const Output& other) {
    const auto& [chemical, colormap, range, own_range, drawing, strength, expressions, name, projection, view] = one;
    const auto same = [](const Expression& a, const Expression& b) { return a.nodes == b.nodes; };
    return std::ranges::equal(expressions, other.expressions, same) && name == other.name &&
           chemical == other.chemical && equal(colormap, other.colormap) && range == other.range &&
           own_range == other.own_range && drawing == other.drawing && strength == other.strength &&
           equal(projection, other.projection) && view == other.view;
}

}  // namespace

void find_unused_chemicals(const Sheet& sheet, Reporter& report) {
    const Uses uses(sheet.experiment);
    const auto& chemicals = sheet.experiment.chemicals;
    const auto& lines = sheet.outline.chemicals;
    const auto unused = [&](std::size_t i) { return !keeps_previous(chemicals[i]) && uses.chemicals.count(i) == 0; };
    for (std::size_t i = 0; i < chemicals.size(); ++i) {
        if (!unused(i)) continue;
        const std::size_t first = i;  // of those that one line defines
        while (i + 1 < chemicals.size() && unused(i + 1) && lines[i + 1] == lines[i]) ++i;
        const std::string& name = chemicals[first].name;
        report(sheet.place(lines[first], name),
               first == i ? fmt::format("no rule and no output names chemical '{}'", name)
                          : fmt::format("no rule and no output names any of the chemicals '{}' to '{}'", name,
                                        chemicals[i].name));
    }
}

void find_unused_mappings(const Sheet& sheet, Reporter& report) {
    const Uses uses(sheet.experiment);
    for (std::size_t i = 0; i < sheet.experiment.mappings.size(); ++i) {
        if (uses.mappings.count(i) > 0) continue;
        const std::string& name = sheet.experiment.mappings[i];
        report(sheet.place(sheet.outline.mappings[i], name), fmt::format("no rule reads the mapping '{}'", name));
    }
}

void find_unused_fields(const Sheet& sheet, Reporter& report) {
    const Uses uses(sheet.experiment);
    for (std::size_t i = 0; i < sheet.experiment.fields.size(); ++i) {
        const PlaceField& field = sheet.experiment.fields[i];
        if (field.name.empty() || uses.fields.count(i) > 0) continue;
        report(sheet.place(field.line, field.name), fmt::format("nothing reads the field '{}'", field.name));
    }
}

void find_unused_stencils(const Sheet& sheet, Reporter& report) {
    const Uses uses(sheet.experiment);
    for (std::size_t i = 0; i < sheet.experiment.stencils.size(); ++i) {
        const NamedStencil& stencil = sheet.experiment.stencils[i];
        if (uses.stencils.count(i) > 0) continue;
        report(sheet.place(stencil.line, stencil.name), fmt::format("no rule takes the stencil '{}'", stencil.name));
    }
}

void find_unused_colours(const Sheet& sheet, Reporter& report) {
    const bool slots_drawn = std::ranges::any_of(sheet.experiment.outputs, [](const Output& output) {
        return !output.rgb() && (output.colormap.name == "gradient" || output.colormap.name == "striped");
    });
    const auto has_own_map = [&](std::size_t line) {
        Cursor words = sheet.read(line);
        while (!words.done() && !words.take("colormap")) words.next();
        return !words.done();
    };
    const bool selection_drawn =
        sheet.outline.outputs.empty() || !std::ranges::all_of(sheet.outline.outputs, has_own_map);
    bool told = slots_drawn;  // once for all slots
    for (const Outline::Statement& statement : sheet.outline.statements) {
        if (statement.what == "colormap select" && !selection_drawn) {
            report(sheet.place(statement.line),
                   "every output has a colormap of its own, so the selected one is not used");
        } else if (statement.what == "colormap slot" && !told) {
            told = true;
            report(sheet.place(statement.line),
                   "no picture uses the slots; they make the maps 'gradient' and 'striped', as in "
                   "'colormap select gradient'");
        }
    }
}

void find_equal_outputs(const Sheet& sheet, Reporter& report) {
    const std::vector<Output>& outputs = sheet.experiment.outputs;
    for (std::size_t i = 1; i < sheet.outline.outputs.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (!equal(outputs[i], outputs[k])) continue;
            report(sheet.place(sheet.outline.outputs[i]),
                   fmt::format("line {} draws the same picture", sheet.outline.outputs[k]));
            break;
        }
    }
}

void find_unused_parameters(const Sheet& sheet, Reporter& report) {
    const auto names = [&](const Outline::Statement& statement, const Parameter& parameter) {
        Cursor words = sheet.read(statement.line);
        bool found = false;
        while (!found && !words.done()) {
            const Token& token = words.next();
            found = token.quoted || is_expression(token) ? names_word(token.text, parameter.name)
                                                         : token.text == parameter.name;
        }
        return found && statement.line != parameter.line;
    };
    for (const Parameter& one : sheet.experiment.parameters) {
        const auto uses = [&](const Outline::Statement& statement) { return names(statement, one); };
        if (std::ranges::any_of(sheet.outline.statements, uses)) continue;
        report(sheet.place(one.line, one.name), fmt::format("nothing takes its number from parameter '{}'", one.name));
    }
}

}  // namespace pelage::language
