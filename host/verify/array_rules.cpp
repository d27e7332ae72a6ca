// See array_text.hpp: rules. Numbers are such that conditions hold in some cells, and that what a rule does is seen.
#include "core/models.hpp"
#include "verify/array_quantities.hpp"
#include "verify/array_text.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace pelage::verify {

namespace {

class RuleWriter {
public:
    RuleWriter(const GeneratedCase& one, std::size_t nth)
        : case_(one),
          nth_(nth),
          values_(one.realm, one.made->rules[nth]),
          start_(std::stoull(values_["start"])),
          chemicals_(generated_chemicals(one)),
          quantities_(one, nth) {}

    std::string lines() const {
        std::string text;
        const std::string when = timing();
        if (values_["joined"] == "and") {
            const char* what = action() == "divide" ? "probability 0.15" : "if G conc >= 1";
            text += fmt::format("rule {}{} and\n", when, what);
        }
        return text + fmt::format("rule {}{} {}\n", when, condition(), act());
    }

private:
    static std::string number(double value) { return fmt::format("{}", value); }

    const std::string& action() const { return values_["action"]; }

    // Counted from the start of the run, or of the phase that the rule belongs to.
    std::string timing() const {
        const std::string& when = values_["when"];
        if (action() == "divide" && when == "interval") return fmt::format("from {0} until {0} ", start_ + 18);
        if (action() == "divide" && when != "phase") return fmt::format("every 11 offset {} ", start_ + 1 + nth_ % 3);
        if (when == "interval") return fmt::format("from {} until {} ", start_ + nth_ % 2, start_ + end());
        if (when == "every") return fmt::format("every {} ", 2 + nth_ % 3);
        if (when == "offset") return fmt::format("every 3 offset {} ", start_ + 2);
        if (when == "phase") return action() == "divide" ? "every 7 offset 3 " : "every 2 offset 1 ";
        return "";
    }

    // Without rules that have ended free cells have another program. Where phases make another one already, nothing
    // ends.
    std::uint64_t end() const { return case_.realm != Realm::cells || values_["ends"] == "bounded" ? 11 : 18; }

    // ---- when and where

    std::string condition() const {
        const std::string& how = values_["condition"];
        if (how == "always") return how;
        const std::string& what = values_["read"];
        if (how == "probability") return "probability " + quantities_.text(what);
        const std::string& against = values_["against"];
        const std::string left = what == "number" ? (against == "alike" ? "4" : "1.25") : quantities_.compared(what);
        const double low = quantities_.middle(what);
        const std::string right =
            against == "number" ? number(low) : std::string(QuantityWriter::partner(what, against == "alike"));
        if (how != "in") return fmt::format("if {} {} {}", left, how, right);
        const std::string high = number(what == "RANDOM" ? 0.9 : what == "diff" ? 0.25 : low + 3);
        return nth_ % 2 == 0 ? fmt::format("if {} in {} {}", left, right, high)
                             : fmt::format("if {} in {} {}", left, number(what == "RANDOM" ? 0.1 : -2), right);
    }

    // ---- what is done

    const std::string& one_of(const std::string& first, const std::string& middle, const std::string& last) const {
        const std::string& target = values_["target"];
        return target == "first" ? first : target == "middle" ? middle : last;
    }

    std::string amount(double plain) const {
        const std::string& what = values_["amount"];
        return what == "number" ? number(plain) : quantities_.text(what);
    }

    std::string deviation(double value) const { return values_["deviation"] == "yes" ? " dev " + number(value) : ""; }

    std::string act() const {
        const double some = static_cast<double>(nth_ + 1);
        const std::string& what = action();
        if (what == "change conc")
            return fmt::format("change {} conc {}{}", one_of("A", "B", "W"), amount(0.0625 * some), deviation(0.3));
        if (what == "change diff")
            return fmt::format("change {} diff {}{}", one_of("D", "Q", "E"), amount(-0.003 * some), deviation(0.01));
        if (what == "set conc") return fmt::format("set {} conc {}", one_of("A", "B", "W"), amount(1 + 0.125 * some));
        if (what == "set diff") return fmt::format("set {} diff {}", one_of("D", "Q", "E"), amount(0.01 * some));
        if (what == "map") return map();
        if (what == "polarize")
            return fmt::format("polarize {} conc", one_of(chemicals_.front(), "Q", chemicals_.back()));
        if (what == "divide") return fmt::format("divide direction {}{}", amount(37 * some), deviation(40));
        if (what == "move") return fmt::format("move {}{}", amount(0.03 * some), deviation(0.05));
        if (what == "react by") return formula();
        return react(model_named(what.substr(what.find(' ') + 1)).facts());
    }

    std::string formula() const {
        return fmt::format("react {} by {} {} by ({} - 0.5 * {})", one_of("A", "B", "W"), amount(0.5),
                           one_of("Q", "Q", "A"), one_of("A", "B", "W"), one_of("Q", "Q", "A"));
    }

    std::string map() const {
        const double from = quantities_.middle(values_["amount"]);
        const double wide = std::max(1.0, 1e-6 * from);
        const double to = nth_ % 2 == 0 ? 1.5 : -0.5;
        return fmt::format("map {} {} {} to N{} 0.25 {}", amount(1.375), from - 1.25 * wide, from + 1.75 * wide, nth_,
                           to);
    }

    // The amount stands for one of the numbers that the reaction takes; a random one for all of them.
    std::string react(const ModelFacts& model) const {
        std::vector<std::string> pool;
        for (const std::string& name : chemicals_) {
            if (std::string_view("PQRS").find(name[0]) != std::string_view::npos) pool.push_back(name);
        }
        const std::string& target = values_["target"];
        const std::size_t first = target == "first" ? 0 : target == "middle" ? 1 : 2;
        std::string text = "react";
        for (std::size_t i = 0; i < model.species.size(); ++i) text += " " + pool[(first + i) % pool.size()];
        const bool all = values_["amount"] == "RANDOM";
        const std::size_t hit = nth_ % (model.parameters.size() + 1);
        const std::vector<double> plain = sensible(model, nth_ + case_.made->number);
        text += " scale " + (all || hit == 0 ? amount(0.5) : number(0.75)) + " " + model.word;
        for (std::size_t i = 0; i < model.parameters.size(); ++i) {
            const bool one_of_them = all || hit == i + 1;
            text += fmt::format(" {} {}", model.parameters[i].name, one_of_them ? amount(plain[i]) : number(plain[i]));
        }
        return text;
    }

    const GeneratedCase& case_;
    std::size_t nth_;
    Values values_;
    std::uint64_t start_;
    std::vector<std::string> chemicals_;
    QuantityWriter quantities_;
};

}  // namespace

std::string generated_rule(const GeneratedCase& one, std::size_t nth) { return RuleWriter(one, nth).lines(); }

}  // namespace pelage::verify
