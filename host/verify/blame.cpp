// See blame.hpp.
#include "verify/blame.hpp"

#include "reference/backend.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <variant>
#include <vector>

namespace pelage::verify {

namespace {

constexpr std::chrono::seconds patience{10};

std::string line_of(const std::string& text, std::size_t number) {
    std::istringstream lines(text);
    std::string line;
    for (std::size_t i = 0; i < number; ++i) std::getline(lines, line);
    return line;
}

// A rule with those that it is joined to: from the first of them to itself.
struct Joined {
    std::size_t first = 0;
    std::size_t last = 0;
};

std::vector<Joined> joined_rules(const Experiment& experiment) {
    std::vector<Joined> found;
    std::size_t first = 0;
    for (std::size_t i = 0; i < experiment.rules.size(); ++i) {
        if (std::holds_alternative<And>(experiment.rules[i].action)) continue;
        if (!std::holds_alternative<Expand>(experiment.rules[i].action)) found.push_back({first, i});
        first = i + 1;
    }
    return found;
}

void end_for_ever(Rule& rule) {
    rule.from = 1;
    rule.until = 0;
}

class Trial {
public:
    Trial(const Suspect& suspect, Place& place, const Setting& setting)
        : suspect_(suspect), place_(place), setting_(setting), rules_(joined_rules(suspect.experiment)) {}

    std::string verdict() {
        std::vector<Joined> left = rules_;
        if (differs(with({}))) return "without any rule it differs, too\n";
        while (left.size() > 1 && std::chrono::steady_clock::now() - begin_ < patience) {
            const auto middle = left.begin() + static_cast<std::ptrdiff_t>(left.size() / 2);
            const std::vector<Joined> low(left.begin(), middle), high(middle, left.end());
            if (differs(with(low))) {
                left = low;
            } else if (differs(with(high))) {
                left = high;
            } else {
                break;  // it needs rules of both halves
            }
        }
        return left.size() < rules_.size() ? named(left) : "";
    }

private:
    // The experiment, which grows as before, with no other rules.
    Experiment with(const std::vector<Joined>& rules) const {
        Experiment made = suspect_.experiment;
        for (Rule& rule : made.rules) {
            if (!std::holds_alternative<Expand>(rule.action)) end_for_ever(rule);
        }
        for (const Joined& rule : rules) {
            for (std::size_t i = rule.first; i <= rule.last; ++i) made.rules[i] = suspect_.experiment.rules[i];
        }
        return made;
    }

    std::string named(const std::vector<Joined>& rules) const {
        std::string text = "this is enough to make it differ:\n";
        for (const Joined& rule : rules) {
            for (std::size_t i = rule.first; i <= rule.last; ++i)
                text += "  " + line_of(suspect_.text, suspect_.experiment.rules[i].line) + "\n";
        }
        return text;
    }

    bool differs(const Experiment& experiment) {
        const auto expected =
            reference_backend(setting_.precision, setting_.search)->make_tissue(experiment, suspect_.start);
        const auto found = place_.backend(setting_).make_tissue(experiment, suspect_.start);
        expected->advance(suspect_.iterations);
        found->advance(suspect_.iterations);
        Tally tally;
        add(tally, expected->read(), found->read(), setting_.precision, "");
        return !tally.equal();
    }

    const Suspect& suspect_;
    Place& place_;
    const Setting& setting_;
    std::vector<Joined> rules_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

std::string blame(const Suspect& suspect, Place& place, const Setting& setting) {
    return Trial(suspect, place, setting).verdict();
}

}  // namespace pelage::verify
