// See visualpde_meaning.hpp.
#include "import/visualpde_meaning.hpp"

#include "core/error.hpp"
#include "import/c_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pelage::imports {

namespace {

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

TermRef squared(const TermRef& a) { return call_term("^", {a, number_term(2.0)}); }

// A row of five weights, or a column of them from below.
std::vector<std::string> along(bool up, const std::array<const char*, 5>& weights) {
    std::vector<std::string> all(25, "0");
    for (std::size_t i = 0; i < 5; ++i) all[up ? 5 * (4 - i) + 2 : 10 + i] = weights[i];
    return all;
}

const std::vector<PdeDerivative>& derivatives() {
    static const std::vector<PdeDerivative> all{{"xx", 2, {"0", "0", "0", "1", "-2", "1", "0", "0", "0"}},
                                                {"yy", 2, {"0", "1", "0", "0", "-2", "0", "0", "1", "0"}},
                                                {"xy", 2, {"-0.25", "0", "0.25", "0", "0", "0", "0.25", "0", "-0.25"}},
                                                {"xf", 1, {"0", "0", "0", "0", "-1", "1", "0", "0", "0"}},
                                                {"xb", 1, {"0", "0", "0", "-1", "1", "0", "0", "0", "0"}},
                                                {"yf", 1, {"0", "1", "0", "0", "-1", "0", "0", "0", "0"}},
                                                {"yb", 1, {"0", "0", "0", "0", "1", "0", "0", "-1", "0"}},
                                                {"xf2", 1, along(false, {"0", "0", "-1.5", "2", "-0.5"})},
                                                {"xb2", 1, along(false, {"0.5", "-2", "1.5", "0", "0"})},
                                                {"yf2", 1, along(true, {"0", "0", "-1.5", "2", "-0.5"})},
                                                {"yb2", 1, along(true, {"0.5", "-2", "1.5", "0", "0"})}};
    return all;
}

// Uniform draws made normal (Box and Muller 1958); a draw is below 1, so that its complement is above 0.
TermRef normal_draw() {
    const TermRef draw = name_term("RANDOM");
    const TermRef radius =
        call_term("sqrt", {times(number_term(-2.0), call_term("log", {minus(number_term(1.0), draw)}))});
    return times(radius, call_term("cos", {times(times(number_term(2.0), name_term("PI")), draw)}));
}

}  // namespace

PdeMeaning::PdeMeaning(const PdePreset& preset, Draft& draft, NewNames& names, Problems& problems,
                       std::vector<std::string> species, double dx)
    : preset_(preset), draft_(draft), names_(names), problems_(problems), species_(std::move(species)), dx_(dx) {
    collect_parameters();
}

TermRef PdeMeaning::read(const std::string& text, std::string_view key, bool at_start) {
    const std::string before = std::exchange(where_, preset_.at(key));
    const bool start_before = std::exchange(at_start_, at_start);
    const FormulaSource source{where_, 0};
    TermRef term =
        trimmed(text).empty() ? number_term(0.0) : read_formula(text, source, Dialect::visualpde, *this, problems_);
    where_ = before;
    at_start_ = start_before;
    return term;
}

TermRef PdeMeaning::species(std::size_t index) const { return name_term(draft_.chemicals[index].name); }
TermRef PdeMeaning::dx() const { return name_term(draft_.parameters[0].name); }

double PdeMeaning::value(const std::string& name_here) const {
    for (const DraftParameter& one : draft_.parameters) {
        if (one.name == name_here) return value_of(one.value, [this](const std::string& name) { return value(name); });
    }
    return std::numeric_limits<double>::quiet_NaN();
}

bool PdeMeaning::is_constant(const TermRef& term) const {
    return of_names_only(term, [this](const std::string& name) {
        return name == "PI" ||
               std::ranges::find(draft_.parameters, name, &DraftParameter::name) != draft_.parameters.end();
    });
}

// ---- parameters: "NAME = VALUE in [LOW, STEP, HIGH]; ..."

void PdeMeaning::collect_parameters() {
    const std::string all = preset_.field("kineticParams");
    for (std::string_view rest = all; !rest.empty();) {
        const std::size_t end = rest.find(';');
        collect_parameter(trimmed(rest.substr(0, end)));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
}

void PdeMeaning::collect_parameter(std::string_view definition) {
    if (definition.empty()) return;
    const std::size_t equals = definition.find('=');
    const std::string name(trimmed(definition.substr(0, equals)));
    if (equals == std::string_view::npos || name.empty() || parameters_.size() == 1'000)
        throw Error(fmt::format("{}: '{}' is no definition NAME = VALUE", preset_.at("kineticParams"),
                                definition.substr(0, 40)));
    Parameter one;
    std::string_view value = trimmed(definition.substr(equals + 1));
    const std::size_t bracket = value.find('[');
    const std::size_t word = bracket == std::string_view::npos ? bracket : value.rfind("in", bracket);
    if (word != std::string_view::npos) {
        const std::string numbers(value.substr(bracket + 1, value.find(']', bracket) - bracket - 1));
        const std::size_t first = numbers.find(','), last = numbers.rfind(',');
        double low = 0.0, high = 0.0;
        const bool read = first != std::string::npos && std::sscanf(numbers.c_str(), "%lf", &low) == 1 &&
                          std::sscanf(numbers.c_str() + last + 1, "%lf", &high) == 1;
        if (read && std::isfinite(low) && std::isfinite(high) && low < high) one.range = {low, high};
        value = trimmed(value.substr(0, word));
    }
    one.text = std::string(value);
    parameters_[name] = std::move(one);
}

// One of numbers and parameters becomes a parameter here; anything else is put in wherever it is named.
TermRef PdeMeaning::parameter(const std::string& name, const FormulaToken& token) {
    Parameter& one = parameters_.find(name)->second;
    if (one.term) return one.term;
    if (one.being_read || ++depth_ > 50) {
        problems_.refuse(
            fmt::format("{}: parameter '{}' is defined by itself", preset_.at("kineticParams"), token.text));
        return one.term = number_term(1.0);
    }
    one.being_read = true;
    const TermRef term = read(one.text, "kineticParams");
    --depth_;
    one.being_read = false;
    if (!is_constant(term)) return one.term = term;
    const std::string here = names_.of(name);
    if (here != name) problems_.note(fmt::format("parameter '{}' is called '{}' here", name, here));
    draft_.parameters.push_back({here, term, {}});
    const double now = value(here);
    if (one.range && one.range->first <= now && now <= one.range->second) draft_.parameters.back().range = one.range;
    return one.term = name_term(here);
}

// ---- names

TermRef PdeMeaning::refused(const FormulaToken& token, std::string_view what) {
    problems_.refuse(fmt::format("{}: '{}' {}", where_, token.text, what));
    return number_term(1.0);
}

TermRef PdeMeaning::length(std::string_view name, double size) {
    const std::string here = names_.of(name);
    if (std::isnan(value(here))) draft_.parameters.push_back({here, number_term(size), {}});
    return name_term(here);
}

TermRef PdeMeaning::x() const {
    TermRef place = times(plus(name_term("COLUMN"), number_term(0.5)), dx());
    return place;
}

TermRef PdeMeaning::y() const { return times(plus(name_term("ROW"), number_term(0.5)), dx()); }

std::optional<TermRef> PdeMeaning::of_domain(std::string_view name) {
    const double width = static_cast<double>(draft_.columns) * dx_, height = static_cast<double>(draft_.rows) * dx_;
    if (name == "x") return plus(x(), read(preset_.field("minX"), "minX"));
    if (name == "y") return plus(y(), read(preset_.field("minY"), "minY"));
    if (name == "t") return at_start_ ? number_term(0.0) : name_term("TIME");
    if (name == "dx" || name == "dy") return dx();
    if (name == "dt") return name_term(draft_.parameters[1].name);
    if (name == "L") return length(name, std::max(width, height));
    if (name == "L_x") return length(name, width);
    if (name == "L_y") return length(name, height);
    if (name == "L_min") return length(name, std::min(width, height));
    if (name == "pi" || name == "PI") return name_term("PI");
    return std::nullopt;
}

std::optional<TermRef> PdeMeaning::random(std::string_view name) const {
    if (name == "RAND" || name.starts_with("RAND_")) return name_term("RANDOM");
    if (name == "RANDN" || name.starts_with("RANDN_")) return normal_draw();
    if (name != "WhiteNoise" && !name.starts_with("WhiteNoise_")) return std::nullopt;
    const TermRef step = name_term(draft_.parameters[1].name);
    const TermRef volume = draft_.rows == 1 ? dx() : times(dx(), dx());
    return over(normal_draw(), call_term("sqrt", {times(step, volume)}));
}

TermRef PdeMeaning::of_name(const FormulaToken& token) {
    const std::string name(token.text);
    const auto found = std::ranges::find(species_, name);
    if (found != species_.end()) return species(static_cast<std::size_t>(found - species_.begin()));
    if (parameters_.contains(name)) return parameter(name, token);
    if (const auto term = of_domain(name)) return *term;
    if (const auto term = random(name)) return *term;
    if (const auto term = slope(token)) return *term;
    if (name.starts_with("I_S") || name.starts_with("I_T"))
        return refused(token, "is an image of VisualPDE's, which the preset does not hold");
    return refused(token, "is no species, parameter or word that is known here");
}

// u_x, u_xx, u_xb, ...
std::optional<TermRef> PdeMeaning::slope(const FormulaToken& token) {
    for (std::size_t i = 0; i < species_.size(); ++i) {
        if (!token.text.starts_with(species_[i] + "_")) continue;
        const std::string_view kind = token.text.substr(species_[i].size() + 1);
        if (kind.find_first_not_of("xyfb2") == std::string_view::npos)
            return slope_of(draft_.chemicals[i].name, kind, token);
    }
    return std::nullopt;
}

TermRef PdeMeaning::slope_of(const std::string& chemical, std::string_view kind, const FormulaToken& token) {
    const TermRef rise = over(call_term("gradient_x", {name_term(chemical)}), dx());
    if (at_start_) return refused(token, "is a slope, which is known in rules alone");
    if (kind == "x") return rise;
    if (kind == "y") return over(call_term("gradient_y", {name_term(chemical)}), dx());
    if (kind == "xx" && draft_.rows == 1) return over(call_term("laplacian", {name_term(chemical)}), times(dx(), dx()));
    for (const PdeDerivative& one : derivatives()) {
        if (one.kind != kind) continue;
        const TermRef sum = call_term(named_stencil(one), {name_term(chemical)});
        return over(sum, one.powers_of_dx == 1 ? dx() : times(dx(), dx()));
    }
    return refused(token, "is a derivative that is not carried over");
}

// The name here of its stencil, which is defined where it is not yet.
std::string PdeMeaning::named_stencil(const PdeDerivative& one) {
    const std::string here = names_.of("difference_" + std::string(one.kind));
    if (std::ranges::find(draft_.stencils, here, &DraftStencil::name) == draft_.stencils.end())
        draft_.stencils.push_back({here, one.weights});
    return here;
}

// ---- functions

// 1 in the middle, 0 from the radius on.
TermRef PdeMeaning::bump(const std::vector<TermRef>& a) {
    const FormulaToken none;
    const TermRef column = *of_domain("x");
    TermRef far = squared(minus(column, a[0]));
    if (draft_.rows != 1) {
        const TermRef middle = a.size() == 3 ? a[1] : over(*of_domain("L_y"), number_term(2.0));
        far = plus(far, squared(minus(*of_domain("y"), middle)));
    }
    const TermRef part = over(far, squared(a.back()));
    const TermRef height =
        call_term("exp", {minus(number_term(1.0), over(number_term(1.0), minus(number_term(1.0), part)))});
    return choice(call_term("<", {part, number_term(1.0)}), height, number_term(0.0));
}

TermRef PdeMeaning::gauss(const std::vector<TermRef>& a) {
    const TermRef wide = a[2], high = a.size() > 3 ? a[3] : a[2], bound = a.size() > 4 ? a[4] : number_term(0.0);
    const TermRef x_part = over(minus(*of_domain("x"), a[0]), wide), y_part = over(minus(*of_domain("y"), a[1]), high);
    const TermRef two = number_term(2.0);
    const TermRef rest = minus(number_term(1.0), times(bound, bound));
    const TermRef power =
        over(minus(over(plus(squared(x_part), squared(y_part)), two), times(bound, times(x_part, y_part))), rest);
    const TermRef area = times(times(times(times(two, name_term("PI")), wide), high), call_term("sqrt", {rest}));
    return over(call_term("exp", {negated(power)}), area);
}

TermRef PdeMeaning::of_call(const FormulaToken& token, std::vector<TermRef> arguments) {
    const std::string_view name = token.text;
    const std::size_t count = arguments.size();
    if ((name == "ind" || name == "float") && count == 1) return arguments[0];
    if (name == "H" && (count == 1 || count == 2)) {
        const TermRef at = count == 1 ? arguments[0] : minus(arguments[0], arguments[1]);
        return call_term("smoothstep", {number_term(-0.01), number_term(0.01), at});
    }
    if (name == "Bump" && (count == 2 || count == 3)) return bump(arguments);
    if (name == "Gauss" && count >= 3 && count <= 5) return gauss(arguments);
    const auto inverse = [&](const char* of) { return over(number_term(1.0), call_term(of, arguments)); };
    if (name == "sech" && count == 1) return inverse("cosh");
    if (name == "sec" && count == 1) return inverse("cos");
    if (name == "csc" && count == 1) return inverse("sin");
    if (name == "cot" && count == 1) return inverse("tan");
    if (name == "coth" && count == 1) return inverse("tanh");
    if (const auto term = c_function(name, arguments)) return *term;
    if (name.starts_with("I_S") || name.starts_with("I_T"))
        return refused(token, "is an image of VisualPDE's, which the preset does not hold");
    if (std::ranges::find(species_, name) != species_.end() || parameters_.contains(name))
        return refused(token, "is no function; a product needs its '*'");
    return refused(token, "is no function that is known here");
}

}  // namespace pelage::imports
