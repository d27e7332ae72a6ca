// What rules of a random experiment read: operands and conditions.
#include "verify/random_draft.hpp"

#include <algorithm>
#include <cmath>

namespace pelage::verify {

namespace {

struct Readable {  // an operand, and where its values mostly lie
    std::string text;
    double low = 0.0, high = 1.0;
    bool whole = false;
};

Readable chemical_value(Draft& draft) {
    const ChemicalDraft& chemical = draft.any_chemical();
    if (draft.dice.chance(70)) {
        return {chemical.name + " conc", chemical.conc - chemical.spread, chemical.conc + chemical.spread};
    }
    return {chemical.name + " diff", 0.0, chemical.rate};
}

// A coordinate: the words along the first axis, the second, and the third.
Readable coordinate(Draft& draft, std::size_t axes) {
    const std::size_t axis = draft.dice.below(axes);
    const std::size_t counts[] = {draft.columns, draft.rows, draft.layers};
    double reach = draft.kind == TissueKind::mesh ? draft.radius : 8.0;
    if (draft.grid()) reach = static_cast<double>(counts[axis]);
    return {std::string(1, "XYZ"[axis]), -reach, reach};
}

Readable place_value(Draft& draft) {
    const bool deep = draft.kind == TissueKind::volume;
    const std::size_t axes = deep || draft.kind == TissueKind::mesh ? 3 : 2;
    if (!draft.grid() || draft.dice.chance(33)) return coordinate(draft, axes);
    const auto across = static_cast<double>(draft.columns), up = static_cast<double>(draft.rows);
    const auto behind = static_cast<double>(draft.layers);
    switch (draft.dice.below(deep ? 6 : 4)) {
        case 0:
            return {"ROW", 0.0, up, true};
        case 1:
            return {"COLUMN", 0.0, across, true};
        case 2:
            return {"ROWS", 0.0, 1.5 * up, true};
        case 3:
            return {"COLUMNS", 0.0, 1.5 * across, true};
        case 4:
            return {"LAYER", 0.0, behind, true};
        default:
            return {"LAYERS", 0.0, 1.5 * behind, true};
    }
}

Readable time_value(Draft& draft) {
    const double end = static_cast<double>(draft.iterations);
    switch (draft.dice.below(4)) {
        case 0:
            return {"TIME", 0.0, end * draft.time_step};
        case 1:
            return {"AGE", 0.0, end, true};
        case 2:
            return {"BIRTH", 0.0, end, true};
        default:
            return {"ITERATION", 0.0, end, true};
    }
}

Readable readable(Draft& draft) {
    const unsigned mapping_weight = draft.mappings.empty() ? 0 : 4;
    switch (draft.dice.weighted({6, mapping_weight, 3, 2, 2, 2, 2})) {
        case 0:
            return chemical_value(draft);
        case 1: {
            const MappingDraft& mapping = draft.mappings[draft.dice.below(draft.mappings.size())];
            return {mapping.name, std::min(mapping.low, mapping.high), std::max(mapping.low, mapping.high)};
        }
        case 2:
            return place_value(draft);
        case 3:
            return time_value(draft);
        case 4:
            return {"NEIGHBORS", 0.0, 9.0, true};
        case 5:
            return {draw_expression(draft, ExpressionScope::rule, 0.0, 2.0), 0.0, 2.0};
        default:
            return {"RANDOM", 0.0, 1.0};
    }
}

std::string near(Draft& draft, const Readable& other) {
    if (!other.whole) return draft.value(other.low, other.high);
    return draft.dice.number(std::floor(draft.dice.real(other.low, other.high)));
}

std::string comparison(Draft& draft) {
    const Readable left = readable(draft);
    const std::string right = draft.dice.chance(75) ? near(draft, left) : draw_operand(draft);
    const char* symbol = draft.dice.pick({"==", "!=", "<", "<=", ">", ">="});
    if (draft.dice.chance(15)) return words({"if", right, symbol, left.text});
    return words({"if", left.text, symbol, right});
}

std::string within(Draft& draft) {
    const Readable value = readable(draft);
    const std::string low = draft.dice.chance(80) ? near(draft, value) : draw_operand(draft);
    const std::string high = draft.dice.chance(80) ? near(draft, value) : draw_operand(draft);
    return words({"if", value.text, "in", low, high});
}

}  // namespace

std::string draw_operand(Draft& draft) { return readable(draft).text; }

std::string draw_parameter(Draft& draft, double low, double high) {
    if (draft.dice.chance(8)) return draw_expression(draft, ExpressionScope::rule, low, high);
    return draft.dice.chance(85) ? draft.value(low, high) : draw_operand(draft);
}

std::string draw_condition(Draft& draft) {
    switch (draft.dice.weighted({40, 28, 16, 16, 8})) {
        case 0:
            return "always";
        case 1:
            return comparison(draft);
        case 2:
            return within(draft);
        case 4:
            return "if " + draw_truth(draft);
        default:
            return "probability " + (draft.dice.chance(75) ? draft.dice.number(0.0, 1.0) : draw_operand(draft));
    }
}

}  // namespace pelage::verify
