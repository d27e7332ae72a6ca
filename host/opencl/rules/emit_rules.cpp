// See emit_rules.hpp.
#include "opencl/rules/emit_rules.hpp"

#include "core/functions.hpp"
#include "core/philox.hpp"
#include "core/subnormal.hpp"
#include "opencl/rules/emit_operand.hpp"
#include "opencl/rules/emit_whole.hpp"
#include "opencl/rules/functions.hpp"
#include "opencl/rules/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>
#include <variant>

namespace pelage {

namespace {

std::string kernel_name(Model model) {
    std::string name = model.facts().word;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

// The iterations at which a rule acts, as Rule::active(), in numbers of 32 bits: from `low` to `high`, each `every`th
// from `low` of the first cycle on. Values past 32 bits never come.
struct Interval {
    std::uint32_t low = 1, high = 0;  // never
    std::uint32_t first = 0;
    std::uint32_t every = 1;
};

Interval interval_of(const Rule& rule) {
    const auto past = [](std::uint64_t value) { return value > largest_iteration; };
    if (rule.offset > largest_iteration - std::min<std::uint64_t>(rule.origin, largest_iteration) ||
        past(rule.origin) || past(rule.from)) {
        return {};
    }
    const std::uint64_t first = rule.origin + rule.offset;
    const bool once = past(rule.every);
    const std::uint64_t until = std::min<std::uint64_t>(rule.until, once ? first : largest_iteration);
    return {static_cast<std::uint32_t>(std::max(rule.from, first)), static_cast<std::uint32_t>(until),
            static_cast<std::uint32_t>(first),
            once ? 1u : static_cast<std::uint32_t>(std::max<std::uint64_t>(rule.every, 1))};
}

// True at these iterations.
std::string interval(const Rule& rule, Numbers& numbers) {
    const Interval when = interval_of(rule);
    const std::string low = numbers.word(when.low);
    const std::string high = numbers.word(when.high);
    const std::string first = numbers.word(when.first);
    const std::string every = numbers.word(when.every);
    const std::string text = fmt::format("iteration >= {} && iteration <= {}", low, high);
    return rule.every > 1 ? fmt::format("{} && (iteration - {}) % {} == 0", text, first, every) : text;
}

// Emits one rule: its condition as mask t<place>, then its action. Pieces go to `out`.
class RuleEmitter {
public:
    RuleEmitter(RuleText& out, Numbers& numbers, const Experiment& experiment, std::size_t place, std::size_t divide,
                Precision precision)
        : out_(out),
          numbers_(numbers),
          rule_(experiment.rules[place]),
          place_(place),
          divide_(divide),
          precision_(precision),
          operands_(experiment, place, numbers) {}

    // `handed`: mask of the `and` rule before, or empty. `interval`: when to act, or empty for always.
    void emit(const std::string& handed, const std::string& interval_test) {
        std::string condition = std::visit([&](const auto& c) { return test(c); }, rule_.condition);
        const std::string declarations = operands_.take_declarations();
        if (!interval_test.empty()) condition = join(fmt::format("UNIFORM({})", interval_test), condition);
        if (!handed.empty()) condition = join(handed, condition);
        always_ = condition.empty();
        line(fmt::format("// rule {}", place_));
        out_.rules += declarations;
        line(fmt::format("const mask t{} = {};", place_, always_ ? "ALL_TRUE" : condition));
        std::visit([&](const auto& action) { act(action); }, rule_.action);
        operands_.note_use(out_.use);
        out_.shared += operands_.take_shared();
    }

private:
    static std::string join(const std::string& a, const std::string& b) {
        return b.empty() ? a : fmt::format("{} & {}", a, b);
    }

    void line(const std::string& text) { out_.rules += text + "\n"; }

    std::string truth() const { return fmt::format("t{}", place_); }

    // target = value, where the rule holds.
    void assign(const std::string& target, const std::string& value) {
        line(always_ ? fmt::format("{} = {};", target, value)
                     : fmt::format("{} = SELECT({}, {}, {});", target, truth(), value, target));
    }

    std::string number(double value) { return numbers_.real(value); }

    std::string test(const Always&) { return ""; }
    std::string test(const Compare& c) {
        if (compared_exactly(c.left, c.right)) return operands_.exactly(c.left, c.comparison, c.right);
        const std::string left = operands_.text(c.left);
        return fmt::format("({} {} {})", left, symbol(c.comparison), operands_.text(c.right));
    }
    std::string test(const Within& c) {
        const bool low_exact = compared_exactly(c.low, c.value);
        const bool high_exact = compared_exactly(c.value, c.high);
        const std::string value = low_exact && high_exact ? "" : operands_.text(c.value);
        const std::string low = low_exact ? operands_.exactly(c.low, Comparison::less_equal, c.value)
                                          : fmt::format("({} <= {})", operands_.text(c.low), value);
        const std::string high = high_exact ? operands_.exactly(c.value, Comparison::less_equal, c.high)
                                            : fmt::format("({} <= {})", value, operands_.text(c.high));
        return fmt::format("{} & {}", low, high);
    }

    std::string test(const Probability& c) {
        const std::string chance = operands_.text(c.chance);
        return fmt::format("({} < {})", operands_.draw(purpose::condition), chance);
    }

    // Draws are made and expressions computed only if some lane needs them.
    template <class Body>
    void guarded(Body&& body) {
        const bool guard = operands_.has_declarations() && !always_;
        if (guard) line(fmt::format("if (ANY({})) {{", truth()));
        out_.rules += operands_.take_declarations();
        body();
        if (guard) line("}");
    }

    std::string deviated(const Operand& amount, double deviation) {
        const std::string middle = operands_.text(amount);
        if (in_precision<float>(deviation) == 0.0f && (precision_ == Precision::single_ || deviation == 0.0))
            return middle;
        const std::string u = operands_.draw(purpose::deviation);
        return fmt::format("({} + {} * (({} + {}) - R(1)))", middle, number(deviation), u, u);
    }

    void act(const React& react) {
        const ModelFacts& model = react.model.facts();
        std::string arguments = operands_.text(react.scale) + ", dt";
        for (const std::size_t chemical : react.species) arguments += fmt::format(", c{}", chemical);
        for (const Operand& parameter : react.parameters) arguments += ", " + operands_.text(parameter);
        out_.use.reacts.insert(react.model.index);
        const auto changed = std::span(react.species).first(model.changed());
        out_.use.concentrations_written.insert(changed.begin(), changed.end());
        for (const std::size_t kept : std::span(react.species).subspan(changed.size()))
            out_.use.concentrations_read.insert(kept);
        guarded([&] {
            for (std::size_t i = 0; i < changed.size(); ++i) {
                assign(fmt::format("n{}", changed[i]), fmt::format("{}_{}(n{}, {})", kernel_name(react.model),
                                                                   model.species[i].name, changed[i], arguments));
            }
        });
    }

    void act(const Formula& formula) {
        std::vector<std::string> rates;
        for (const Formula::Part& part : formula.parts) {
            out_.use.concentrations_written.insert(part.chemical);
            rates.push_back(operands_.text(part.rate));
        }
        guarded([&] {
            for (std::size_t i = 0; i < rates.size(); ++i) {
                const std::string target = fmt::format("n{}", formula.parts[i].chemical);
                assign(target, fmt::format("ADD_REACTION({}, R(1), {}, dt)", target, rates[i]));
            }
        });
    }

    void act(const Neural& neural) {
        out_.use.neural = true;
        out_.use.concentrations_written.insert(neural.species.begin(), neural.species.end());
        const std::string rate = operands_.text(neural.rate);
        const std::string diffusion = operands_.text(neural.diffusion);
        const std::string table = numbers_.table(network_table(*neural.network));
        const std::size_t count = neural.species.size();
        line(always_ ? "{" : fmt::format("if (ANY({})) {{", truth()));
        out_.rules += operands_.take_declarations();
        std::string old;
        for (const std::size_t chemical : neural.species)
            old += fmt::format("{}c{}", old.empty() ? "" : ", ", chemical);
        line(fmt::format("const real x[{}] = {{{}}};\nreal f[{}];", count, old, count));
        line(fmt::format("pelage_network({}, {}, {}, x, f);", count, neural.network->hidden, table));
        line(fmt::format("const real speed = {} * dt;", rate));
        if (!neural.still()) line(fmt::format("const real spread = {} * dt;", diffusion));
        for (std::size_t i = 0; i < count; ++i) add_network(neural, i);
        line("}");
    }
    void add_network(const Neural& neural, std::size_t place) {
        const std::size_t chemical = neural.species[place];
        const std::string target = fmt::format("n{}", chemical);
        if (!neural.still()) {
            const std::string share = emit_number(group_rate(place, neural.species.size()), precision_);
            const std::string laplacian = operands_.text({Quantity::laplacian, 0.0, chemical});
            assign(target, fmt::format("fma(spread * {}, {}, {})", share, laplacian, target));
        }
        assign(target, fmt::format("fma(speed, f[{}], {})", place, target));
    }

    void act(const Change& change) {
        const bool rate = change.target == Target::rate;
        (rate ? out_.use.rates_written : out_.use.concentrations_written).insert(change.chemical);
        const std::string target = fmt::format("{}{}", rate ? 'q' : 'n', change.chemical);
        const std::string amount = deviated(change.amount, change.deviation);
        guarded([&] {
            assign(target, fmt::format("{} + {}", target, amount));
            if (rate) assign(target, fmt::format("SELECT({} < R(0), R(0), {})", target, target));
        });
    }

    void act(const Set& set) {
        const bool rate = set.target == Target::rate;
        (rate ? out_.use.rates_written : out_.use.sets).insert(set.chemical);
        if (!rate) out_.use.concentrations_written.insert(set.chemical);
        const std::string value = operands_.text(set.value);
        guarded([&] {
            assign(fmt::format("{}{}", rate ? "sq" : "s", set.chemical), value);
            assign(fmt::format("{}{}", rate ? "eq" : "e", set.chemical), "ALL_TRUE");
        });
    }

    void act(const Map& map) {
        out_.use.mappings_written.insert(map.mapping);
        const std::string value = operands_.text(map.value);
        const std::string from_low = number(map.from_low), from_high = number(map.from_high);
        const std::string to_low = number(map.to_low), to_high = number(map.to_high);
        guarded([&] {
            assign(fmt::format("m{}", map.mapping), fmt::format("SELECT({0} < {1}, {3}, SELECT({0} > {2}, {4}, "
                                                                "(({0} - {1}) / ({2} - {1})) * ({4} - {3}) + {3}))",
                                                                value, from_low, from_high, to_low, to_high));
        });
    }

    void act(const Polarize& polarize) {
        for (const std::size_t i : out_.use.polarizes) {  // the last active rule wins
            if (i != polarize.chemical) line(fmt::format("g{0} = g{0} & !{1};", i, truth()));
        }
        line(fmt::format("g{0} = g{0} | {1};", polarize.chemical, truth()));
    }

    void act(const Divide& divide) {
        out_.use.polarity = true;
        out_.use.divides = true;
        const std::string degrees = deviated(divide.direction, divide.deviation);
        guarded([&] { line(fmt::format("DIVIDE({}, {}, {}, {});", divide_, place_, truth(), degrees)); });
    }

    void act(const Move& move) {
        out_.use.polarity = true;
        const std::string distance = deviated(move.distance, move.deviation);
        guarded([&] { line(fmt::format("MOVE({}, {});", truth(), distance)); });
    }

    void act(const And&) {}
    void act(const Expand&) {}
    void act(const Aggregate&) {}

    RuleText& out_;
    Numbers& numbers_;
    const Rule& rule_;
    std::size_t place_;
    std::size_t divide_;
    Precision precision_;
    OperandEmitter operands_;
    bool always_ = true;
};

bool sets_rate(const Rule& rule, std::size_t chemical) {
    const auto* set = std::get_if<Set>(&rule.action);
    return set != nullptr && set->target == Target::rate && set->chemical == chemical;
}

// Declarations before the rules and what follows them, once it is known which chemicals they touch.
void frame(RuleText& text, const Experiment& experiment, const std::vector<bool>& active) {
    std::string before;
    std::string after;
    for (const std::size_t i : text.use.sets) {
        before += fmt::format("mask e{0} = ALL_FALSE;\nreal s{0} = R(0);\n", i);
        text.replace += fmt::format("n{0} = SELECT(e{0}, s{0}, n{0});\n", i);
    }
    for (const std::size_t i : text.use.rates_written) {
        bool set = false;
        for (std::size_t k = 0; k < active.size(); ++k) set = set || (active[k] && sets_rate(experiment.rules[k], i));
        if (!set) continue;
        before += fmt::format("mask eq{0} = ALL_FALSE;\nreal sq{0} = R(0);\n", i);
        after += fmt::format("q{0} = SELECT(eq{0}, SELECT(sq{0} < R(0), R(0), sq{0}), q{0});\n", i);
    }
    for (const std::size_t i : text.use.polarizes) before += fmt::format("mask g{} = ALL_FALSE;\n", i);
    text.rules = before + text.rules + after;
}

}  // namespace

RuleText emit_rules(const Experiment& experiment, const std::vector<bool>& active, Precision precision,
                    bool test_intervals) {
    RuleText text;
    for (std::size_t place = 0; place < experiment.rules.size(); ++place) {
        const auto* polarize = std::get_if<Polarize>(&experiment.rules[place].action);
        if (polarize != nullptr && active[place]) text.use.polarizes.insert(polarize->chemical);
    }
    std::string handed;
    std::size_t divides = 0;
    for (std::size_t place = 0; place < experiment.rules.size(); ++place) {
        const Rule& rule = experiment.rules[place];
        const std::size_t divide = std::holds_alternative<Divide>(rule.action) ? divides++ : divides;
        const bool conjunction = std::holds_alternative<And>(rule.action);
        const std::string given = std::exchange(handed, "");
        if (conjunction) handed = active[place] && given != "ALL_FALSE" ? fmt::format("t{}", place) : "ALL_FALSE";
        const bool acts = active[place] && given != "ALL_FALSE" && !std::holds_alternative<Expand>(rule.action);
        RuleText left_out;  // whose numbers are counted all the same
        text.numbers.declare(acts && test_intervals);
        const std::string when = interval(rule, text.numbers);
        text.numbers.declare(acts);
        RuleEmitter(acts ? text : left_out, text.numbers, experiment, place, divide, precision)
            .emit(given, test_intervals ? when : "");
    }
    frame(text, experiment, active);
    return text;
}

std::vector<KernelNumber> rule_parameters(const Experiment& experiment, Precision precision) {
    return emit_rules(experiment, std::vector<bool>(experiment.rules.size()), precision).numbers.values();
}

std::vector<std::string> rule_files(const RuleUse& use) {
    std::vector<std::string> files = function_files(
        use.functions, use.neural ? std::vector<std::string>{"quick_sigmoid"} : std::vector<std::string>{});
    files.emplace_back("rules/reaction.cl");
    if (use.neural) files.insert(files.end(), {"common/four.cl", "rules/neural.cl"});
    for (const std::size_t model : use.reacts) files.push_back("models/" + kernel_name(Model{model}) + ".cl");
    return files;
}

}  // namespace pelage
