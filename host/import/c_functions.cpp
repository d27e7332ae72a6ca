// See c_functions.hpp.
#include "import/c_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace pelage::imports {

namespace {

using Terms = std::vector<TermRef>;

struct SameFunction {
    std::string_view theirs, ours;
    std::size_t arguments;
};

constexpr std::array<SameFunction, 48> same_functions{{{"mod", "mod", 2},
                                                       {"exp", "exp", 1},
                                                       {"log", "log", 1},
                                                       {"sin", "sin", 1},
                                                       {"cos", "cos", 1},
                                                       {"tan", "tan", 1},
                                                       {"asin", "asin", 1},
                                                       {"acos", "acos", 1},
                                                       {"atan", "atan", 1},
                                                       {"atan", "atan2", 2},
                                                       {"atan2", "atan2", 2},
                                                       {"sinh", "sinh", 1},
                                                       {"cosh", "cosh", 1},
                                                       {"tanh", "tanh", 1},
                                                       {"sqrt", "sqrt", 1},
                                                       {"fabs", "abs", 1},
                                                       {"abs", "abs", 1},
                                                       {"floor", "floor", 1},
                                                       {"ceil", "ceil", 1},
                                                       {"round", "round", 1},
                                                       {"rint", "round", 1},
                                                       {"min", "min", 2},
                                                       {"max", "max", 2},
                                                       {"fmin", "min", 2},
                                                       {"fmax", "max", 2},
                                                       {"clamp", "clamp", 3},
                                                       {"step", "step", 2},
                                                       {"mix", "mix", 3},
                                                       {"smoothstep", "smoothstep", 3},
                                                       {"hypot", "hypot", 2},
                                                       {"pow", "pow", 2},
                                                       {"powr", "pow", 2},
                                                       {"pown", "pow", 2},
                                                       {"safepow", "pow", 2},
                                                       {"safetanh", "tanh", 1},
                                                       {"native_exp", "exp", 1},
                                                       {"native_log", "log", 1},
                                                       {"native_sin", "sin", 1},
                                                       {"native_cos", "cos", 1},
                                                       {"native_tan", "tan", 1},
                                                       {"native_sqrt", "sqrt", 1},
                                                       {"native_powr", "pow", 2},
                                                       {"half_exp", "exp", 1},
                                                       {"half_log", "log", 1},
                                                       {"half_sin", "sin", 1},
                                                       {"half_cos", "cos", 1},
                                                       {"half_sqrt", "sqrt", 1},
                                                       {"half_powr", "pow", 2}}};

TermRef one(double value) { return number_term(value); }

TermRef whole_part(const TermRef& x) {
    return choice(call_term("<", {x, one(0.0)}), call_term("ceil", {x}), call_term("floor", {x}));
}

TermRef sign_of(const TermRef& x) {
    return choice(call_term(">", {x, one(0.0)}), one(1.0), choice(call_term("<", {x, one(0.0)}), one(-1.0), one(0.0)));
}

// A choice whose condition is a vector of truths: OpenCL's select(otherwise, then, condition).
TermRef selected(const TermRef& otherwise, const TermRef& then, const TermRef& condition) {
    return choice(is_truth(condition) ? condition : call_term("<", {condition, one(0.0)}), then, otherwise);
}

using Maker = TermRef (*)(const Terms&);

struct MadeFunction {
    std::string_view name;
    std::size_t arguments;
    Maker make;
};

TermRef compare_terms(std::string_view sign, const Terms& a) { return call_term(sign, a); }

constexpr std::array<MadeFunction, 29> made_functions{{
    {"exp2", 1,
     [](const Terms& a) {
         return call_term("pow", {one(2.0), a[0]});
     }},
    {"exp10", 1,
     [](const Terms& a) {
         return call_term("pow", {one(10.0), a[0]});
     }},
    {"expm1", 1, [](const Terms& a) { return minus(call_term("exp", {a[0]}), one(1.0)); }},
    {"log2", 1, [](const Terms& a) { return over(call_term("log", {a[0]}), call_term("log", {one(2.0)})); }},
    {"log10", 1, [](const Terms& a) { return over(call_term("log", {a[0]}), call_term("log", {one(10.0)})); }},
    {"log1p", 1, [](const Terms& a) { return call_term("log", {plus(one(1.0), a[0])}); }},
    {"rsqrt", 1, [](const Terms& a) { return over(one(1.0), call_term("sqrt", {a[0]})); }},
    {"inversesqrt", 1, [](const Terms& a) { return over(one(1.0), call_term("sqrt", {a[0]})); }},
    {"native_rsqrt", 1, [](const Terms& a) { return over(one(1.0), call_term("sqrt", {a[0]})); }},
    {"native_recip", 1, [](const Terms& a) { return over(one(1.0), a[0]); }},
    {"native_divide", 2, [](const Terms& a) { return over(a[0], a[1]); }},
    {"cbrt", 1,
     [](const Terms& a) {
         return times(sign_of(a[0]), call_term("pow", {call_term("abs", {a[0]}), over(one(1.0), one(3.0))}));
     }},
    {"trunc", 1, [](const Terms& a) { return whole_part(a[0]); }},
    {"fract", 1, [](const Terms& a) { return minus(a[0], call_term("floor", {a[0]})); }},
    {"sign", 1, [](const Terms& a) { return sign_of(a[0]); }},
    {"fmod", 2, [](const Terms& a) { return minus(a[0], times(a[1], whole_part(over(a[0], a[1])))); }},
    {"fdim", 2,
     [](const Terms& a) {
         return call_term("max", {minus(a[0], a[1]), one(0.0)});
     }},
    {"mad", 3, [](const Terms& a) { return plus(times(a[0], a[1]), a[2]); }},
    {"fma", 3, [](const Terms& a) { return plus(times(a[0], a[1]), a[2]); }},
    {"degrees", 1, [](const Terms& a) { return times(a[0], one(180.0 / std::numbers::pi)); }},
    {"radians", 1, [](const Terms& a) { return times(a[0], one(std::numbers::pi / 180.0)); }},
    {"select", 3, [](const Terms& a) { return selected(a[0], a[1], a[2]); }},
    {"isless", 2, [](const Terms& a) { return compare_terms("<", a); }},
    {"islessequal", 2, [](const Terms& a) { return compare_terms("<=", a); }},
    {"isgreater", 2, [](const Terms& a) { return compare_terms(">", a); }},
    {"isgreaterequal", 2, [](const Terms& a) { return compare_terms(">=", a); }},
    {"isequal", 2, [](const Terms& a) { return compare_terms("==", a); }},
    {"isnotequal", 2, [](const Terms& a) { return compare_terms("!=", a); }},
    {"maxmag", 2,
     [](const Terms& a) {
         return choice(call_term(">=", {call_term("abs", {a[0]}), call_term("abs", {a[1]})}), a[0], a[1]);
     }},
}};

}  // namespace

std::optional<TermRef> c_function(std::string_view name, const std::vector<TermRef>& arguments) {
    for (const SameFunction& same : same_functions) {
        if (same.theirs != name || same.arguments != arguments.size()) continue;
        const bool power = same.ours == "pow" && (is_number(arguments[1], 2.0) || is_number(arguments[1], 3.0));
        return call_term(power ? "^" : same.ours, arguments);
    }
    for (const MadeFunction& made : made_functions) {
        if (made.name == name && made.arguments == arguments.size()) return made.make(arguments);
    }
    return std::nullopt;
}

std::optional<TermRef> c_constant(std::string_view name) {
    static const std::map<std::string_view, double> constants{
        {"M_E", std::numbers::e},         {"M_LN2", std::numbers::ln2},           {"M_SQRT2", std::numbers::sqrt2},
        {"M_PI_2", std::numbers::pi / 2}, {"M_PI_4", std::numbers::pi / 4},       {"M_1_PI", std::numbers::inv_pi},
        {"M_LN10", std::numbers::ln10},   {"M_SQRT1_2", std::numbers::sqrt2 / 2}, {"M_2_PI", 2 * std::numbers::inv_pi}};
    if (name.ends_with("_F")) name.remove_suffix(2);
    if (name == "M_PI") return name_term("PI");
    const auto found = constants.find(name);
    if (found == constants.end()) return std::nullopt;
    return number_term(found->second);
}

}  // namespace pelage::imports
