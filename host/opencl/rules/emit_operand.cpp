// See emit_operand.hpp.
#include "opencl/rules/emit_operand.hpp"

#include "core/philox.hpp"
#include "core/subnormal.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pelage {

std::string emit_number(double value, Precision precision) {
    const bool single = precision == Precision::single_;
    const double rounded = single ? double{in_precision<float>(value)} : value;
    if (std::isnan(rounded)) return "R(NAN)";
    if (std::isinf(rounded)) return rounded < 0 ? "R(-INFINITY)" : "R(INFINITY)";
    return fmt::format("R({}{:a}{})", std::signbit(rounded) ? "-" : "", std::fabs(rounded), single ? "f" : "");
}

std::string OperandEmitter::whole(const Operand& operand) {
    use_.quantities.insert(operand.quantity);
    switch (operand.quantity) {
        case Quantity::neighbours:
            return "WHOLE_NEIGHBOURS";
        case Quantity::age:
            return "WHOLE_AGE";
        case Quantity::birth:
            return "WHOLE_BIRTH";
        case Quantity::row:
            return "WHOLE_ROW";
        case Quantity::column:
            return "WHOLE_COLUMN";
        case Quantity::rows:
            return "WHOLE_ROWS";
        case Quantity::columns:
            return "WHOLE_COLUMNS";
        default:
            return "WHOLE_ITERATION";
    }
}

std::string OperandEmitter::text(const Operand& operand) {
    if (is_whole(operand.quantity)) return fmt::format("TO_REAL({})", whole(operand));
    switch (operand.quantity) {
        case Quantity::number:
            return numbers_.real(operand.value);
        case Quantity::x:
            use_.quantities.insert(operand.quantity);
            return "GET_X";
        case Quantity::y:
            use_.quantities.insert(operand.quantity);
            return "GET_Y";
        case Quantity::random: {
            const std::uint32_t nth = randoms_++;
            const std::uint32_t purpose = purpose::operand + 16 * (nth / 4);
            need(purpose);
            return fmt::format("UNIT(w{}_{}.{})", rule_, purpose, "xyzw"[nth % 4]);
        }
        case Quantity::concentration:
            use_.concentrations_read.insert(operand.index);
            return fmt::format("c{}", operand.index);
        case Quantity::rate:
            use_.rates_read.insert(operand.index);
            return fmt::format("r{}", operand.index);
        case Quantity::mapping:
            use_.mappings_read.insert(operand.index);
            return fmt::format("m{}", operand.index);
        default:
            break;
    }
    return "R(0)";
}

std::string OperandEmitter::draw(std::uint32_t purpose) {
    need(purpose);
    return fmt::format("UNIT(w{}_{}.x)", rule_, purpose);
}

void OperandEmitter::need(std::uint32_t purpose) {
    use_.random = true;
    if (!declared_.insert(purpose).second) return;
    pending_ += fmt::format(
        "const struct pelage_words w{0}_{1} = DRAW(id, iteration, {0}u, {1}u, seed_low, seed_high);\n", rule_, purpose);
}

std::string OperandEmitter::take_draws() {
    std::string text;
    text.swap(pending_);
    return text;
}

void OperandEmitter::note_use(RuleUse& use) const {
    use.concentrations_read.insert(use_.concentrations_read.begin(), use_.concentrations_read.end());
    use.rates_read.insert(use_.rates_read.begin(), use_.rates_read.end());
    use.mappings_read.insert(use_.mappings_read.begin(), use_.mappings_read.end());
    use.quantities.insert(use_.quantities.begin(), use_.quantities.end());
    use.random = use.random || use_.random;
}

}  // namespace pelage
