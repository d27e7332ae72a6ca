// Ready's rules: formulas, and the one that is built in.
#include "import/c_functions.hpp"
#include "import/diffusion.hpp"
#include "import/ready.hpp"
#include "import/ready_program.hpp"
#include "import/ready_stencils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

namespace pelage::imports {

namespace {

// The name here of a stencil, which is defined where it is not yet.
std::string named_stencil(ReadyPattern& pattern, const std::string& name, const ReadyStencil& stencil) {
    const std::string here = pattern.names.of(name);
    if (std::ranges::find(pattern.draft.stencils, here, &DraftStencil::name) != pattern.draft.stencils.end())
        return here;
    DraftStencil made{here, {}};
    for (const int weight : stencil.weights)
        made.weights.push_back(weight % stencil.divisor == 0 ? fmt::format("{}", weight / stencil.divisor)
                                                             : fmt::format("({} / {})", weight, stencil.divisor));
    pattern.draft.stencils.push_back(std::move(made));
    return here;
}

// Where nothing flows over the edge Ready repeats the edge cell, so that a corner has diagonal neighbours: a Laplacian
// in an expression has none there.
TermRef with_edges_repeated(ReadyPattern& pattern, const TermRef& term) {
    if (term->arguments.empty()) return term;
    std::vector<TermRef> arguments;
    for (const TermRef& one : term->arguments) arguments.push_back(with_edges_repeated(pattern, one));
    if (term->text == "laplacian")
        return call_term(named_stencil(pattern, "laplacian_", *ready_stencil("laplacian", false)), arguments);
    return arguments == term->arguments ? term : call_term(term->text, arguments);
}

std::string rule_text(ReadyPattern& pattern, const TermRef& term) {
    const bool open = pattern.draft.edge == "no-flux" && !pattern.one_dimensional;
    return text_of(open ? with_edges_repeated(pattern, term) : term);
}

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
        if (name == "index_x") return of_fours("COLUMN");
        if (name == "index_y") return name_term("ROW");
        if (name == "X") return pattern_.in_fours ? over(name_term("COLUMNS"), number_term(4.0)) : name_term("COLUMNS");
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

    // Patterns before format 6 see four cells of a row as a vector, those beside it as others: a_w.w is the cell on the
    // left of a.x, and north is down.
    std::optional<TermRef> of_part(const FormulaToken& token, std::string_view part) override {
        static constexpr std::string_view parts = "xyzw";
        const std::size_t index = part.size() == 1 ? parts.find(part[0]) : std::string_view::npos;
        if (!pattern_.of_old_format || index == std::string_view::npos || lane_ < 0) return std::nullopt;
        for (const std::string& original : pattern_.chemicals) {
            const std::string_view name = token.text;
            if (name != original && !name.starts_with(original + "_")) continue;
            const auto block = name == original ? ReadyOffset{} : ready_offset(name.substr(original.size() + 1));
            if (!block) continue;
            const ReadyOffset offset{4 * block->right + static_cast<int>(index) - lane_, -block->up};
            return cell_beside(offset, pattern_.names.of(original));
        }
        return std::nullopt;
    }
    void look_at_lane(int lane) override { lane_ = lane; }

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

    TermRef of_fours(std::string_view place) const {
        return pattern_.in_fours ? call_term("floor", {over(name_term(place), number_term(4.0))}) : name_term(place);
    }

    // laplacian_a, x_gradient_a, ..., bilaplacian_a, ..., and cells around: a_n, a_se, ...
    std::optional<TermRef> of_chemical(std::string_view name) {
        for (const std::string& original : pattern_.chemicals) {
            const std::string chemical = pattern_.names.of(original);
            if (name.starts_with(original + "_")) {
                const auto offset = ready_offset(name.substr(original.size() + 1));
                if (const auto cell = offset ? cell_beside(*offset, chemical) : std::nullopt) return cell;
            }
            if (!name.ends_with("_" + original)) continue;
            const std::string_view word = name.substr(0, name.size() - original.size() - 1);
            if (word == "laplacian") return slope("laplacian", chemical, 2);
            if (word == "x_gradient") return slope("gradient_x", chemical, 1);
            if (word == "y_gradient") return slope("gradient_y", chemical, 1);
            if (word == "z_gradient") return number_term(0.0);
            if (word == "gradient_mag_squared") return steepness(chemical);
            if (const auto known = ready_stencil(word, pattern_.one_dimensional))
                return stencil(std::string(word), *known, chemical);
        }
        return std::nullopt;
    }

    std::optional<TermRef> cell_beside(ReadyOffset offset, const std::string& chemical) {
        if (pattern_.one_dimensional) offset.up = 0;
        if (offset.right == 0 && offset.up == 0) return name_term(chemical);
        const auto cell = ready_cell(offset, pattern_.one_dimensional);
        if (!cell) return std::nullopt;
        const auto part = [](int far, const char* onward, const char* back) {
            return far == 0 ? std::string() : (far > 0 ? onward : back) + std::to_string(std::abs(far));
        };
        const std::string name = "cell_" + part(offset.up, "up", "down") + part(offset.right, "right", "left");
        return stencil(name, *cell, chemical);
    }

    TermRef stencil(const std::string& name, const ReadyStencil& weights, const std::string& chemical) {
        const TermRef term = call_term(named_stencil(pattern_, name, weights), {name_term(chemical)});
        if (weights.powers_of_dx == 0 || !pattern_.parameters.contains("dx")) return term;
        const TermRef dx = name_term(pattern_.names.of("dx"));
        TermRef power = dx;
        for (int i = 1; i < weights.powers_of_dx; ++i) power = times(power, dx);
        return over(term, power);
    }

    TermRef steepness(const std::string& chemical) {
        const TermRef x = slope("gradient_x", chemical, 1), y = slope("gradient_y", chemical, 1);
        const TermRef square = times(x, x);
        return pattern_.one_dimensional ? square : plus(square, times(y, y));
    }

    std::string reason(std::string_view name) const {
        const auto starts = [&](std::string_view what) { return name.starts_with(what); };
        for (const std::string& chemical : pattern_.chemicals) {
            if (starts(chemical + "_in")) return "is the whole image; only cells up to three away can be carried over";
            if (starts(chemical + "_"))
                return "is no keyword that is known here, or the value of a cell that is more than three away";
        }
        return "is no chemical, parameter or keyword that is known here";
    }

    ReadyPattern& pattern_;
    const FormulaSource& source_;
    int lane_ = outside_vectors;
};

void set_rules(ReadyPattern& pattern, const ReadyProgram& program, bool has_timestep) {
    std::string reactions;
    for (std::size_t i = 0; i < pattern.chemicals.size(); ++i) {
        DraftChemical& chemical = pattern.draft.chemicals[i];
        const TermRef value = program.variable(pattern.chemicals[i]);
        TermRef change = program.variable("delta_" + pattern.chemicals[i]);
        if (!(is_name(value) && value->text == chemical.name)) {
            const TermRef step = has_timestep ? name_term(pattern.names.of("timestep")) : number_term(1.0);
            pattern.draft.rules.push_back(fmt::format("rule always set {} conc ({})", chemical.name,
                                                      rule_text(pattern, plus(value, times(step, change)))));
            continue;
        }
        const auto constant = [&](const std::string& name) { return pattern.is_parameter(name) || name == "PI"; };
        const auto known = [&](const std::string& name) { return pattern.value(name); };
        take_diffusion(change, chemical, constant, known);
        if (!is_number(change, 0.0)) reactions += fmt::format(" {} by ({})", chemical.name, rule_text(pattern, change));
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
    if (const std::string* cells = formula.attribute("block_size_x")) pattern.in_fours = *cells == "4";
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
