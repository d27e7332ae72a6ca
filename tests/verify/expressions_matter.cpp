// In the generated experiments every operator of expressions, and each of their fields, matters.
#include "core/prepattern.hpp"
#include "reference/backend.hpp"
#include "verify/array_text.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace pelage;
using namespace pelage::verify;

namespace {

// The node with another operator, or with its arguments the other way round.
std::vector<ExpressionNode> others_than(const ExpressionNode& node) {
    std::vector<ExpressionNode> others;
    const auto with = [&](Operation operation) {
        others.push_back(node);
        others.back().operation = operation;
    };
    switch (node.operation) {
        case Operation::add:
            with(Operation::subtract);
            break;
        case Operation::subtract:
        case Operation::multiply:
        case Operation::divide:
            with(Operation::add);
            break;
        case Operation::conjunction:
            with(Operation::disjunction);
            break;
        case Operation::disjunction:
            with(Operation::conjunction);
            break;
        case Operation::compare:
            for (const Comparison one : {Comparison::equal, Comparison::not_equal, Comparison::less,
                                         Comparison::less_equal, Comparison::greater, Comparison::greater_equal}) {
                others.push_back(node);
                others.back().comparison = one;
            }
            break;
        case Operation::choice:
            others.push_back(node);
            std::swap(others.back().arguments[1], others.back().arguments[2]);
            break;
        case Operation::negate:  // twice what it is, or nothing
            others.push_back(node);
            others.back().operation = Operation::subtract;
            others.back().arguments.push_back(node.arguments[0]);
            break;
        case Operation::negation:
            others.push_back(node);
            others.back().operation = Operation::conjunction;
            others.back().arguments.push_back(node.arguments[0]);
            break;
        default:
            break;
    }
    return others;
}

std::string name_of(const ExpressionNode& before, const ExpressionNode& after) {
    const auto number = [](auto word) { return std::to_string(static_cast<int>(word)); };
    const std::string name = "operation " + number(before.operation);
    if (before.operation != Operation::compare) return name;
    return name + ", comparison " + number(before.comparison) + ", not " + number(after.comparison);
}

class Altered {
public:
    explicit Altered(Realm realm) : realm_(realm) {
        for (const GeneratedWorld& world : generated_worlds(realm, 2)) look_at(world);
    }

    std::set<std::string> all, shown;

private:
    void look_at(const GeneratedWorld& world) {
        const GeneratedCase one{&world, realm_, realm_ == Realm::lattice ? Size{17, 11} : Size{11, 5}};
        experiment_ = generated_experiment(one, generated_text(one));
        start_ = initial_state(experiment_, Precision::double_);
        set_stage(one, start_);
        const Snapshot expected = after(experiment_);
        for (std::size_t i = 0; i < experiment_.expressions.size(); ++i) {
            for (std::size_t k = 0; k < experiment_.expressions[i].nodes.size(); ++k) look_at(i, k, expected);
        }
    }

    void look_at(std::size_t nth, std::size_t place, const Snapshot& expected) {
        const ExpressionNode node = experiment_.expressions[nth].nodes[place];
        for (const ExpressionNode& other : others_than(node)) {
            if (other == node) continue;
            const std::string name = name_of(node, other);
            all.insert(name);
            if (shown.contains(name)) continue;
            Experiment changed = experiment_;
            changed.expressions[nth].nodes[place] = other;
            const Snapshot found = after(changed);
            if (found.conc != expected.conc || found.diff != expected.diff || found.mappings != expected.mappings)
                shown.insert(name);
        }
    }

    Snapshot after(const Experiment& one) const {
        const auto tissue = reference_backend(Precision::double_)->make_tissue(one, start_);
        tissue->advance(8);
        return tissue->read();
    }

    Realm realm_;
    Experiment experiment_;
    Snapshot start_;
};

}  // namespace

TEST_CASE("every operator of expressions shows in a generated experiment") {
    const Realm realm = GENERATE(Realm::lattice, Realm::cells);
    const Altered altered(realm);
    CAPTURE(realm == Realm::lattice);
    CHECK(altered.all.size() == 9 + 6 * 5);
    for (const std::string& name : altered.all) {
        CAPTURE(name);
        CHECK(altered.shown.contains(name));
    }
}
