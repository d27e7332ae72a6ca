// Lints of what is described and not needed: chemicals, mappings, colours, pictures.
#include "language/expression.hpp"
#include "language/lints.hpp"
#include "language/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace pelage::language {

namespace {

// What the rules, all of them, touch.
class Uses {
public:
    explicit Uses(const Experiment& experiment) : experiment_(experiment) {
        for (const Rule& rule : experiment.rules) {
            std::visit([&](const auto& condition) { look(condition); }, rule.condition);
            std::visit([&](const auto& action) { look(action); }, rule.action);
        }
    }
    std::set<std::size_t> chemicals;
    std::set<std::size_t> mappings;  // that are read

private:
    void read(const Operand& operand) {
        if (operand.quantity == Quantity::expression) {
            each_operand(experiment_.expressions[operand.index], [&](const Operand& part) { read(part); });
        }
        if (operand.quantity == Quantity::mapping) mappings.insert(operand.index);
        if (operand.quantity == Quantity::concentration || operand.quantity == Quantity::rate)
            chemicals.insert(operand.index);
    }
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

// A member that is added one day makes this line wrong, and so cannot be forgotten.
bool equal(const Output& one, const Output& other) {
    const auto& [chemical, colormap, range, own_range, drawing, strength] = one;
    return chemical == other.chemical && equal(colormap, other.colormap) && range == other.range &&
           own_range == other.own_range && drawing == other.drawing && strength == other.strength;
}

}  // namespace

void find_unused_chemicals(const Sheet& sheet, Reporter& report) {
    const Uses uses(sheet.experiment);
    for (std::size_t i = 0; i < sheet.experiment.chemicals.size(); ++i) {
        const bool drawn =
            std::ranges::any_of(sheet.experiment.outputs, [&](const Output& output) { return output.chemical == i; });
        if (drawn || uses.chemicals.count(i) > 0) continue;
        const std::string& name = sheet.experiment.chemicals[i].name;
        report(sheet.place(sheet.outline.chemicals[i], name),
               fmt::format("no rule and no output names chemical '{}'", name));
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

void find_unused_colours(const Sheet& sheet, Reporter& report) {
    const bool slots_drawn = std::ranges::any_of(sheet.experiment.outputs, [](const Output& output) {
        return output.colormap.name == "gradient" || output.colormap.name == "striped";
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

// Whether the name stands in the text, with nothing before or behind that would make it another one.
bool names_word(std::string_view text, std::string_view name) {
    const auto part = [&](std::size_t at) { return at < text.size() && in_name(text[at]); };
    for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
        if ((at == 0 || !part(at - 1)) && !part(at + name.size())) return true;
    }
    return false;
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
