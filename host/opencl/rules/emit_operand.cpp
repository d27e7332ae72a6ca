// See emit_operand.hpp.
#include "opencl/rules/emit_operand.hpp"

#include "core/functions.hpp"
#include "core/philox.hpp"
#include "core/subnormal.hpp"
#include "opencl/rules/emit_whole.hpp"

#include <fmt/format.h>

#include <algorithm>
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
        case Quantity::layer:
            return "WHOLE_LAYER";
        case Quantity::layers:
            return "WHOLE_LAYERS";
        case Quantity::rows:
            return "WHOLE_ROWS";
        case Quantity::columns:
            return "WHOLE_COLUMNS";
        default:
            return "WHOLE_ITERATION";
    }
}

std::string OperandEmitter::text(const Operand& operand) {
    if (is_whole(operand.quantity)) return fmt::format("TO_REAL(W({}))", whole(operand));
    switch (operand.quantity) {
        case Quantity::number:
            return numbers_.real(operand.value);
        case Quantity::x:
            use_.quantities.insert(operand.quantity);
            return "GET_X";
        case Quantity::y:
            use_.quantities.insert(operand.quantity);
            return "GET_Y";
        case Quantity::z:
            use_.quantities.insert(operand.quantity);
            return "GET_Z";
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
        case Quantity::time:
            use_.quantities.insert(operand.quantity);
            return "GET_TIME";
        case Quantity::laplacian:
            use_.laplacians.insert(operand.index);
            return fmt::format("lap{}", operand.index);
        case Quantity::gradient_x:
            use_.gradients.insert(operand.index);
            return fmt::format("slope_x{}", operand.index);
        case Quantity::gradient_y:
            use_.gradients.insert(operand.index);
            return fmt::format("slope_y{}", operand.index);
        case Quantity::gradient_z:
            use_.gradients.insert(operand.index);
            return fmt::format("slope_z{}", operand.index);
        case Quantity::stencil:
            return around(experiment_.stencils[operand.stencil], operand.index);
        case Quantity::field:
            if (const auto* computed = std::get_if<ComputedField>(&experiment_.fields[operand.index].source);
                computed != nullptr && !places_)
                return expression(computed->expression);
            use_.fields.insert(operand.index);
            return fmt::format("z{}", operand.index);
        case Quantity::expression:
            return expression(experiment_.expressions[operand.index]);
        default:
            break;
    }
    return "R(0)";
}

// One sum after another, from the lower left on.
std::string OperandEmitter::around(const NamedStencil& stencil, std::size_t chemical) {
    const int reach = stencil.reach();
    use_.surrounds.insert(chemical);
    use_.reach = std::max(use_.reach, static_cast<std::size_t>(reach));
    std::string sum = "R(0)";
    for (int up = -reach; up <= reach; ++up) {
        for (int right = -reach; right <= reach; ++right) {
            const double weight = stencil.weight(right, up);
            if (weight == 0.0) continue;
            const std::string name = fmt::format("x{}_{}", rule_, parts_++);
            pending_ += fmt::format("const real {} = fma({}, AROUND(a{}, {}, {}), {});\n", name, numbers_.real(weight),
                                    chemical, right, up, sum);
            sum = name;
        }
    }
    return sum;
}

namespace {

// Whether the whole number is the same in all lanes, and a scalar in the kernel: a vector of cells lies in one row.
bool uniform(const Operand& operand) {
    switch (operand.quantity) {
        case Quantity::neighbours:
        case Quantity::age:
        case Quantity::birth:
        case Quantity::column:
            return false;
        default:
            return true;
    }
}

}  // namespace

std::string OperandEmitter::exactly(const Operand& left, Comparison comparison, const Operand& right) {
    if (right.quantity == Quantity::number)
        return emit_whole_test(whole(left), uniform(left), comparison, right.value, numbers_);
    if (left.quantity == Quantity::number)
        return emit_whole_test(whole(right), uniform(right), exchanged(comparison), left.value, numbers_);
    const std::string first = whole(left);
    const bool one_truth = uniform(left) && uniform(right);
    return fmt::format("{}({} {} {})", one_truth ? "UNIFORM" : "TO_MASK", first, symbol(comparison), whole(right));
}

namespace {

bool same_for_all(const Operand& operand) {
    return operand.quantity == Quantity::number || operand.quantity == Quantity::iteration ||
           operand.quantity == Quantity::time;
}

// A node's value in OpenCL C, as a number and as a truth.
struct Value {
    std::string text;
    bool truth = false;
    bool shared = false;  // by all cells in an iteration

    std::string number() const { return truth ? fmt::format("SELECT({}, R(1), R(0))", text) : text; }
    std::string mask() const { return truth ? text : fmt::format("({} != R(0))", text); }
};

std::string computed(const ExpressionNode& node, const std::vector<Value>& values) {
    const auto number = [&](std::size_t nth) { return values[node.arguments[nth]].number(); };
    const auto mask = [&](std::size_t nth) { return values[node.arguments[nth]].mask(); };
    const auto joined = [&](const char* sign) { return fmt::format("{} {} {}", number(0), sign, number(1)); };
    switch (node.operation) {
        case Operation::operand:
            break;
        case Operation::negate:
            return fmt::format("-{}", number(0));
        case Operation::add:
            return joined("+");
        case Operation::subtract:
            return joined("-");
        case Operation::multiply:
            return joined("*");
        case Operation::divide:
            return joined("/");
        case Operation::compare:
            return joined(symbol(node.comparison));
        case Operation::conjunction:
            return fmt::format("{} & {}", mask(0), mask(1));
        case Operation::disjunction:
            return fmt::format("{} | {}", mask(0), mask(1));
        case Operation::negation:
            return fmt::format("!{}", mask(0));
        case Operation::choice:
            return fmt::format("SELECT({}, {}, {})", mask(0), number(1), number(2));
        case Operation::call:
            break;
    }
    std::string arguments;
    for (std::size_t i = 0; i < node.arguments.size(); ++i) arguments += (i == 0 ? "" : ", ") + number(i);
    return fmt::format("pelage_{}({})", function_table()[node.function].name, arguments);
}

}  // namespace

// Every node that computes something is declared: what is said twice is not computed twice, and nesting has no limit.
// No compiler takes a function such as sin(ITERATION) out of a loop by itself.
std::string OperandEmitter::expression(const Expression& expression) {
    std::vector<Value> values;
    for (const ExpressionNode& node : expression.nodes) {
        if (node.operation == Operation::operand) {
            values.push_back({text(node.operand), false, same_for_all(node.operand)});
            continue;
        }
        const bool truth = gives_truth(node.operation);
        const bool shared = std::ranges::all_of(node.arguments, [&](std::size_t i) { return values[i].shared; });
        std::string value;
        if (node.operation == Operation::compare && compares_exactly(expression, node)) {
            const auto operand = [&](std::size_t nth) { return expression.nodes[node.arguments[nth]].operand; };
            value = exactly(operand(0), node.comparison, operand(1));
        } else {
            value = computed(node, values);
        }
        if (node.operation == Operation::call) use_.functions.insert(node.function);
        const std::string name = fmt::format("x{}_{}", rule_, parts_++);
        (shared ? shared_ : pending_) += fmt::format("const {} {} = {};\n", truth ? "mask" : "real", name, value);
        values.push_back({name, truth, shared});
    }
    return values.back().number();
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

std::string OperandEmitter::take_declarations() {
    std::string text;
    text.swap(pending_);
    return text;
}

void OperandEmitter::note_use(RuleUse& use) const {
    use.concentrations_read.insert(use_.concentrations_read.begin(), use_.concentrations_read.end());
    use.rates_read.insert(use_.rates_read.begin(), use_.rates_read.end());
    use.mappings_read.insert(use_.mappings_read.begin(), use_.mappings_read.end());
    use.quantities.insert(use_.quantities.begin(), use_.quantities.end());
    use.laplacians.insert(use_.laplacians.begin(), use_.laplacians.end());
    use.gradients.insert(use_.gradients.begin(), use_.gradients.end());
    use.surrounds.insert(use_.surrounds.begin(), use_.surrounds.end());
    use.reach = std::max(use.reach, use_.reach);
    use.fields.insert(use_.fields.begin(), use_.fields.end());
    use.functions.insert(use_.functions.begin(), use_.functions.end());
    use.random = use.random || use_.random;
}

}  // namespace pelage
