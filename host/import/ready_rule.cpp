// Ready's rules: formulas, and the one that is built in.
#include "import/c_functions.hpp"
#include "import/diffusion.hpp"
#include "import/ready.hpp"
#include "import/ready_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace pelage::imports {

namespace {

// What the names in Ready's formulas mean, from its page "Writing new rules".
class ReadyMeaning final : public Meaning {
public:
    ReadyMeaning(ReadyPattern& pattern, const FormulaSource& source) : pattern_(pattern), source_(source) {}

    TermRef of_name(const FormulaToken& token) override {
        const std::string_view name = token.text;
        if (pattern_.parameters.contains(name)) return name_term(pattern_.names.of(name));
        if (name == "x_pos") return over(name_term("COLUMN"), name_term("COLUMNS"));
        if (name == "y_pos") return over(name_term("ROW"), name_term("ROWS"));
        if (name == "z_pos") return number_term(0.0);
        if (name == "dx") return number_term(1.0);
        if (name == "index_x") return name_term("COLUMN");
        if (name == "index_y") return name_term("ROW");
        if (name == "X") return name_term("COLUMNS");
        if (name == "Y") return name_term("ROWS");
        if (const auto constant = c_constant(name)) return *constant;
        if (const auto term = of_chemical(name)) return *term;
        return refused(token, fmt::format("'{}' {}", name, reason(name)));
    }

    TermRef of_call(const FormulaToken& token, std::vector<TermRef> arguments) override {
        if (token.text.starts_with("convert_") && arguments.size() == 1) {
            // In vectors, which Ready's formulas are made of, a truth is -1.
            return is_truth(arguments[0]) ? negated(arguments[0]) : arguments[0];
        }
        if (is_ready_type(token.text) && arguments.size() == 1) return arguments[0];
        if (const auto term = c_function(token.text, arguments)) return *term;
        return refused(token,
                       fmt::format("the function '{}' of {} is not carried over", token.text,
                                   arguments.size() == 1 ? "one value" : fmt::format("{} values", arguments.size())));
    }

private:
    TermRef refused(const FormulaToken& token, const std::string& what) {
        pattern_.problems.refuse(fmt::format("{}: {}", source_.at(token.line), what));
        return number_term(1.0);
    }

    TermRef slope(std::string_view word, const std::string& chemical, int powers_of_dx) {
        TermRef term = call_term(word, {name_term(chemical)});
        if (!pattern_.parameters.contains("dx")) return term;
        const TermRef dx = name_term(pattern_.names.of("dx"));
        return over(term, powers_of_dx == 1 ? dx : times(dx, dx));
    }

    // laplacian_a, x_gradient_a, ...; in one dimension a_e and a_w, too.
    std::optional<TermRef> of_chemical(std::string_view name) {
        for (const std::string& original : pattern_.chemicals) {
            if (!name.ends_with("_" + original)) continue;
            const std::string_view word = name.substr(0, name.size() - original.size() - 1);
            const std::string chemical = pattern_.names.of(original);
            if (word == "laplacian") return slope("laplacian", chemical, 2);
            if (word == "x_gradient") return slope("gradient_x", chemical, 1);
            if (word == "y_gradient") return slope("gradient_y", chemical, 1);
            if (word == "z_gradient") return number_term(0.0);
            if (word == "gradient_mag_squared") return steepness(chemical);
        }
        return pattern_.one_dimensional ? beside(name) : std::nullopt;
    }

    TermRef steepness(const std::string& chemical) {
        const TermRef x = slope("gradient_x", chemical, 1), y = slope("gradient_y", chemical, 1);
        const TermRef square = times(x, x);
        return pattern_.one_dimensional ? square : plus(square, times(y, y));
    }

    std::optional<TermRef> beside(std::string_view name) {
        for (const std::string& original : pattern_.chemicals) {
            const std::string chemical = pattern_.names.of(original);
            const TermRef half = times(number_term(0.5), call_term("laplacian", {name_term(chemical)}));
            const TermRef rise = call_term("gradient_x", {name_term(chemical)});
            if (name == original + "_e") return plus(plus(name_term(chemical), rise), half);
            if (name == original + "_w") return plus(minus(name_term(chemical), rise), half);
        }
        return std::nullopt;
    }

    std::string reason(std::string_view name) const {
        const auto starts = [&](std::string_view what) { return name.starts_with(what); };
        if (starts("bilaplacian_") || starts("trilaplacian_") || starts("gaussian_") || starts("sobel") ||
            starts("x_deriv"))
            return "takes a stencil wider than, or other than, those that rules have here; it is not carried over";
        for (const std::string& chemical : pattern_.chemicals) {
            if (starts(chemical + "_in"))
                return "is the whole image; only the values of a cell and its slopes can be carried over";
            if (starts(chemical + "_"))
                return "is a single neighbour's value; only slopes and the Laplacian can be carried over";
        }
        return "is no chemical, parameter or keyword that is known here";
    }

    ReadyPattern& pattern_;
    const FormulaSource& source_;
};

void set_rules(ReadyPattern& pattern, const ReadyProgram& program, bool has_timestep) {
    std::string reactions;
    for (std::size_t i = 0; i < pattern.chemicals.size(); ++i) {
        DraftChemical& chemical = pattern.draft.chemicals[i];
        const TermRef value = program.variable(pattern.chemicals[i]);
        TermRef change = program.variable("delta_" + pattern.chemicals[i]);
        if (!(is_name(value) && value->text == chemical.name)) {
            const TermRef step = has_timestep ? name_term(pattern.names.of("timestep")) : number_term(1.0);
            pattern.draft.rules.push_back(
                fmt::format("rule always set {} conc ({})", chemical.name, text_of(plus(value, times(step, change)))));
            continue;
        }
        const auto constant = [&](const std::string& name) { return pattern.is_parameter(name) || name == "PI"; };
        const auto known = [&](const std::string& name) { return pattern.value(name); };
        take_diffusion(change, chemical, constant, known);
        if (!is_number(change, 0.0)) reactions += fmt::format(" {} by ({})", chemical.name, text_of(change));
    }
    if (!reactions.empty()) pattern.draft.rules.insert(pattern.draft.rules.begin(), "rule always react" + reactions);
}

void read_formula_rule(ReadyPattern& pattern, const XmlElement& formula) {
    std::map<std::string, TermRef, std::less<>> variables;
    for (const std::string& chemical : pattern.chemicals) {
        variables[chemical] = name_term(pattern.names.of(chemical));
        variables["delta_" + chemical] = number_term(0.0);
    }
    const FormulaSource source{pattern.document.name, std::max<std::size_t>(formula.text_line, 1)};
    ReadyMeaning meaning(pattern, source);
    ReadyProgram program(std::move(variables), meaning, pattern.problems);
    program.run(formula.text, source);
    pattern.problems.check();
    set_rules(pattern, program, pattern.parameters.contains("timestep"));
}

// Ready's own Gray-Scott takes the nearest four neighbours.
void read_inbuilt_rule(ReadyPattern& pattern) {
    const std::string name = pattern.required(pattern.rule, "name");
    if (name != "Gray-Scott")
        pattern.fail(pattern.rule, fmt::format("the inbuilt rule '{}' is not known; 'Gray-Scott' is", name));
    for (const char* wanted : {"D_a", "D_b", "F", "k"}) {
        if (!pattern.parameters.contains(wanted))
            pattern.fail(pattern.rule, fmt::format("the inbuilt rule has no parameter '{}'", wanted));
    }
    const auto here = [&](const char* one) { return pattern.names.of(one); };
    pattern.draft.chemicals[0].rate = name_term(here("D_a"));
    pattern.draft.chemicals[1].rate = name_term(here("D_b"));
    pattern.draft.stencil = "five-point";
    pattern.draft.rules.push_back(fmt::format("rule always react a b gray-scott f {} k {}", here("F"), here("k")));
}

}  // namespace

void read_ready_rule(ReadyPattern& pattern) {
    const std::string type = pattern.required(pattern.rule, "type");
    if (type == "inbuilt") return read_inbuilt_rule(pattern);
    if (type == "kernel")
        pattern.fail(pattern.rule,
                     "the rule is a whole OpenCL kernel; only formulas and the inbuilt Gray-Scott can be carried over");
    const XmlElement* formula = pattern.rule.child("formula");
    if (type != "formula" || formula == nullptr)
        pattern.fail(pattern.rule, fmt::format("the rule of type '{}' holds no formula", type));
    read_formula_rule(pattern, *formula);
}

}  // namespace pelage::imports
