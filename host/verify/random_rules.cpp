// Rules of a random experiment: when they act, and what they do.
#include "verify/random_draft.hpp"

#include "core/error.hpp"
#include "core/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace pelage::verify {

namespace {

std::string timing(Draft& draft) {
    Dice& dice = draft.dice;
    const auto span = static_cast<std::size_t>(draft.span);
    std::vector<std::string> options;
    if (dice.chance(20)) options.push_back(fmt::format("from {}", dice.below(span + 1)));
    if (dice.chance(20)) options.push_back(fmt::format("until {}", dice.below(span + 1)));
    if (dice.chance(22)) {
        std::string every = fmt::format("every {}", dice.from_to(1, 1 + span / 3));
        if (dice.chance(50)) every += fmt::format(" offset {}", dice.below(1 + span / 3));
        options.push_back(every);
    }
    return draft.shuffled(options);
}

// A few times in the whole stretch.
std::string seldom(Draft& draft) {
    Dice& dice = draft.dice;
    const auto span = static_cast<std::size_t>(draft.span);
    const std::size_t start = dice.below(span);
    if (dice.chance(30)) return fmt::format("from {} until {}", start, start + dice.below(3));
    std::string text = fmt::format("every {}", dice.from_to(std::max<std::size_t>(3, span / 5), span + 3));
    if (dice.chance(60)) text += fmt::format(" offset {}", dice.below(span));
    return text;
}

// ---- reactions

// A model for which there are chemicals enough.
const ModelFacts& any_model(Draft& draft) {
    const std::vector<std::string>& wanted = draft.limits.models;
    std::vector<const ModelFacts*> fitting;
    for (const ModelFacts& model : model_table()) {
        const bool allowed = wanted.empty() || std::ranges::find(wanted, model.word) != wanted.end();
        if (allowed && model.species.size() <= draft.chemicals.size()) fitting.push_back(&model);
    }
    if (fitting.empty()) throw Error("no reaction that may be drawn takes as few chemicals as the experiment has");
    return *fitting[draft.dice.below(fitting.size())];
}

// A reaction written out, of one chemical or more.
std::string formula(Draft& draft) {
    std::string text = "react";
    const std::size_t parts = draft.dice.from_to(1, std::min<std::size_t>(3, draft.chemicals.size()));
    const double size = 0.05 / draft.time_step;  // so that no iteration leaps
    for (std::size_t i = 0; i < parts; ++i) {
        text += " " + draft.chemicals[i].name + " by ";
        text += draft.dice.chance(90) ? draw_expression(draft, ExpressionScope::rule, -size, size)
                                      : draft.value(-size, size);
    }
    return text;
}

std::string react(Draft& draft) {
    Dice& dice = draft.dice;
    if (dice.chance(20)) return formula(draft);
    const ModelFacts& model = any_model(draft);
    std::vector<std::string> names;
    for (const ChemicalDraft& chemical : draft.chemicals) names.push_back(chemical.name);
    std::string text = "react";
    for (std::size_t i = 0; i < model.species.size(); ++i) {
        const auto chosen = names.begin() + static_cast<std::ptrdiff_t>(dice.below(names.size()));
        text += " " + *chosen;
        names.erase(chosen);
    }
    const double scale = std::min(1.0, 0.05 / draft.time_step);  // so that no iteration leaps
    if (scale < 1.0 || dice.chance(35)) text += " scale " + draw_parameter(draft, 0.125 * scale, scale);
    text += " " + model.word;
    const bool drawn = dice.chance(6);  // all parameters by chance
    for (const auto& [name, low, high] : model.parameters) {
        text += " " + name + " " + (drawn ? "RANDOM" : draw_parameter(draft, low, high));
    }
    return text;
}

// ---- changes

std::string change(Draft& draft) {
    Dice& dice = draft.dice;
    const ChemicalDraft& chemical = draft.any_chemical();
    const bool rate = dice.chance(30);
    const double size = rate ? 0.05 * chemical.rate : 0.06 * chemical.conc;
    std::string text = words({"change", chemical.name, rate ? "diff" : "conc",
                              dice.chance(rate ? 95 : 80) ? draft.value(-size, size) : draw_operand(draft)});
    if (dice.chance(35)) text += " dev " + dice.number(0.0, size);
    return text;
}

std::string replace(Draft& draft) {
    Dice& dice = draft.dice;
    const ChemicalDraft& chemical = draft.any_chemical();
    if (dice.chance(30)) {
        const double most = draft.largest_rate();
        const std::string value = dice.chance(85) ? draft.value(-0.1 * most, most) : draw_operand(draft);
        return words({"set", chemical.name, "diff", value});
    }
    const double low = chemical.conc - 2.0 * chemical.spread;
    const double high = chemical.conc + 2.0 * chemical.spread;
    return words({"set", chemical.name, "conc", dice.chance(60) ? draft.value(low, high) : draw_operand(draft)});
}

std::string map(Draft& draft) {
    Dice& dice = draft.dice;
    const char* const names[] = {"M", "map_2", "Q-factor", "near"};
    const double high = dice.real(0.5, 6.0);
    const std::string low_text = dice.chance(50) ? "0" : dice.number(-high, 0.25);
    const std::string high_text = dice.number(high);
    const std::string from = dice.chance(85) ? words({low_text, high_text}) : words({high_text, low_text});
    const std::string value = draw_operand(draft);
    std::size_t which = dice.below(std::size(names));
    const double to = dice.pick({0.0625, 1.0, 1.0, 4.0, draft.largest_rate(), 180.0});
    MappingDraft mapping{names[which], dice.chance(50) ? 0.0 : -to, to};
    if (dice.chance(25)) std::swap(mapping.low, mapping.high);
    const std::string text =
        words({"map", value, from, "to", mapping.name, dice.number(mapping.low), dice.number(mapping.high)});
    const auto known = std::find_if(draft.mappings.begin(), draft.mappings.end(),
                                    [&](const MappingDraft& one) { return one.name == mapping.name; });
    if (known == draft.mappings.end())
        draft.mappings.push_back(mapping);
    else
        *known = mapping;
    return text;
}

// ---- growth and movement

std::string expand(Draft& draft) {
    Dice& dice = draft.dice;
    std::size_t columns = dice.below(3);
    std::size_t rows = dice.below(3);
    if (columns + rows == 0) columns = rows = 1;
    std::vector<std::string> options;
    if (columns > 0 || dice.chance(30)) options.push_back(fmt::format("columns {}", columns));
    if (rows > 0 || dice.chance(30)) options.push_back(fmt::format("rows {}", rows));
    if (dice.chance(35)) {
        options.push_back(fmt::format("by {}", dice.pick({"nearest", "bilinear", "bicubic"})));
        return words({"expand", draft.shuffled(options)});
    }
    if (dice.chance(40)) options.push_back(fmt::format("first {}", dice.pick({"rows", "columns"})));
    const char* distribution = dice.pick({"", "uniform", "shuffled", "normal", "triangular"});
    if (*distribution != '\0') options.push_back(fmt::format("distribution {}", distribution));
    if (std::string(distribution) != "shuffled" && dice.chance(50)) {
        const bool of_rows = rows > 0 && (columns == 0 || dice.chance(50));
        const double low = dice.real(0.0, 1.0);
        options.push_back(words({"weight", dice.number(0.125, 4.0), of_rows ? "rows" : "columns", dice.number(low),
                                 "to", dice.number(low, 1.0)}));
    }
    return words({"expand", draft.shuffled(options)});
}

std::string divide(Draft& draft) {
    if (draft.dice.chance(35)) return "divide";
    std::string text = "divide direction " + draw_parameter(draft, -360.0, 720.0);
    if (draft.dice.chance(50)) text += " dev " + draft.dice.number(0.0, 180.0);
    return text;
}

std::string move(Draft& draft) {
    std::string text = "move " + draw_parameter(draft, -0.25, 0.5);
    if (draft.dice.chance(40)) text += " dev " + draft.dice.number(0.0, 0.5);
    return text;
}

void draw_growth(Draft& draft) {
    ++draft.growth_rules;
    if (draft.kind == TissueKind::matrix) {
        draft.line(words({"rule", seldom(draft), "always", expand(draft)}));
    } else if (draft.dice.chance(50)) {
        draft.line(words({"rule", seldom(draft), draw_condition(draft), divide(draft)}));
    } else {
        draft.line(words({"rule probability", draft.dice.number(0.0, 0.05), divide(draft)}));
    }
}

}  // namespace

void draw_rule(Draft& draft) {
    Dice& dice = draft.dice;
    if (draft.kind == TissueKind::charges) {
        const std::string when = timing(draft);
        return draft.line(words({"rule", when, "always", draw_particle(draft)}));
    }
    const bool free = draft.kind == TissueKind::free_cells;
    const bool grows = (free || draft.kind == TissueKind::matrix) && draft.growth_rules < 3;
    const auto kind = dice.weighted({30, 20, 9, draft.plane() ? 8u : 0u, 9, free ? 9u : 0u, 12, grows ? 9u : 0u});
    if (kind == 7) return draw_growth(draft);
    const std::string start = words({"rule", timing(draft), kind == 6 ? "always" : draw_condition(draft)});
    const auto action = [&]() -> std::string {
        switch (kind) {
            case 0:
                return react(draft);
            case 1:
                return change(draft);
            case 2:
                return replace(draft);
            case 3:
                return words({"polarize", draft.any_chemical().name, "conc"});
            case 4:
                return "and";
            case 5:
                return move(draft);
            default:
                return map(draft);
        }
    };
    draft.line(words({start, action()}));
}

}  // namespace pelage::verify
