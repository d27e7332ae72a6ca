// In the generated experiments every parameter of every reaction matters, and every chemical that it changes changes.
#include "core/models.hpp"
#include "core/prepattern.hpp"
#include "reference/backend.hpp"
#include "verify/array_text.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <string>
#include <variant>

using namespace pelage;
using namespace pelage::verify;

namespace {

// What has shown in some experiment of a realm: "turing: alpha", "turing: v".
class Shown {
public:
    explicit Shown(Realm realm) : realm_(realm) {
        for (const GeneratedWorld& world : generated_worlds(realm, 2)) look_at(world);
    }

    bool has(const ModelFacts& model, const std::string& name) const {
        return shown_.contains(model.word + ": " + name);
    }

private:
    void look_at(const GeneratedWorld& world) {
        const GeneratedCase one{&world, realm_, realm_ == Realm::lattice ? Size{7, 5} : Size{5, 3}};
        experiment_ = generated_experiment(one, generated_text(one));
        start_ = initial_state(experiment_, Precision::double_);
        set_stage(one, start_);
        expected_ = after(experiment_);
        for (std::size_t i = 0; i < experiment_.rules.size(); ++i) {
            if (const auto* react = std::get_if<React>(&experiment_.rules[i].action)) look_at(i, *react);
        }
    }

    void look_at(std::size_t rule, const React& react) {
        const ModelFacts& model = react.model.facts();
        Experiment without = experiment_;
        without.rules[rule].from = 1;
        without.rules[rule].until = 0;
        const Snapshot found = after(without);
        for (std::size_t i = 0; i < model.changed(); ++i) {
            const std::size_t chemical = react.species[i];
            if (found.conc[chemical] != expected_.conc[chemical])
                shown_.insert(model.word + ": " + model.species[i].name);
        }
        for (std::size_t i = 0; i < model.parameters.size(); ++i) {
            const std::string name = model.word + ": " + model.parameters[i].name;
            if (shown_.contains(name) || react.parameters[i].quantity != Quantity::number) continue;
            Experiment other = experiment_;
            std::get<React>(other.rules[rule].action).parameters[i] =
                Operand::number(1.0625 * react.parameters[i].value + 0.001);
            if (after(other).conc != expected_.conc) shown_.insert(name);
        }
    }

    Snapshot after(const Experiment& one) const {
        const auto tissue = reference_backend(Precision::double_)->make_tissue(one, start_);
        tissue->advance(8);
        return tissue->read();
    }

    Realm realm_;
    Experiment experiment_;
    Snapshot start_, expected_;
    std::set<std::string> shown_;
};

}  // namespace

TEST_CASE("every parameter of every reaction, and every chemical that it changes, shows in a generated experiment") {
    const Realm realm = GENERATE(Realm::lattice, Realm::cells);
    const Shown shown(realm);
    for (const ModelFacts& model : model_table()) {
        CAPTURE(realm == Realm::lattice, model.word);
        for (const ModelParameter& parameter : model.parameters) {
            INFO(parameter.name);
            CHECK(shown.has(model, parameter.name));
        }
        for (std::size_t i = 0; i < model.changed(); ++i) {
            INFO(model.species[i].name);
            CHECK(shown.has(model, model.species[i].name));
        }
    }
}
