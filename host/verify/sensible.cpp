// See lab.hpp: numbers for the parameters of reactions. Where a reaction holds its production between bounds, most
// numbers hide what others do; those given here show each of them.
#include "core/models.hpp"
#include "core/prepattern.hpp"
#include "reference/backend.hpp"
#include "verify/lab.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace pelage::verify {

namespace {

constexpr std::size_t trial_cells = 64;
constexpr std::size_t enough_cells = trial_cells / 8;  // in which a parameter matters
constexpr std::size_t turns = 200;

double part(double turn) { return turn - std::floor(turn); }

// Another one in each place, so that swapped arguments show.
std::vector<double> numbers(const ModelFacts& model, std::size_t turn) {
    std::vector<double> found;
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
        const auto [name, low, high] = model.parameters[i];
        found.push_back(low + (high - low) * part(0.37 + 0.618 * static_cast<double>(turn + i)));
    }
    return found;
}

// Cells in which the species have values from 0.5 to 4.5.
class ModelTrial {
public:
    explicit ModelTrial(const ModelFacts& model) : model_(model) {
        for (std::size_t i = 0; i < model.species.size(); ++i) {
            std::vector<double> plane(trial_cells);
            for (std::size_t cell = 0; cell < trial_cells; ++cell)
                plane[cell] = 0.5 + 4 * part(static_cast<double>(cell) * std::sqrt(2.0 + static_cast<double>(3 * i)));
            conc_.push_back(plane);
        }
    }

    bool each_matters(const std::vector<double>& parameters) const {
        const auto expected = after(parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            std::vector<double> others = parameters;
            others[i] += 0.01;
            const auto found = after(others);
            std::size_t differing = 0;
            for (std::size_t cell = 0; cell < trial_cells; ++cell) {
                for (std::size_t k = 0; k < found.size(); ++k) {
                    if (found[k][cell] == expected[k][cell]) continue;
                    ++differing;
                    break;
                }
            }
            if (differing < enough_cells) return false;
        }
        return true;
    }

private:
    std::vector<std::vector<double>> after(const std::vector<double>& parameters) const {
        Lab lab = Lab::matrix(trial_cells, 1, Boundary::absorbing);
        std::vector<std::size_t> species;
        for (const ModelSpecies& one : model_.species)
            species.push_back(lab.chemical(one.name, {1, 0}, {0, 0}, unbounded));
        lab.rule(verify::react(model_named(model_.word), species, parameters));
        const Experiment experiment = lab.time_step(0.01).done();
        Snapshot state = initial_state(experiment, Precision::double_);
        state.conc = conc_;
        const auto tissue = reference_backend(Precision::double_)->make_tissue(experiment, state);
        tissue->advance(1);
        return tissue->read().conc;
    }

    const ModelFacts& model_;
    std::vector<std::vector<double>> conc_;
};

}  // namespace

std::vector<double> sensible(const ModelFacts& model, std::size_t turn) {
    static std::map<std::pair<std::string, std::size_t>, std::vector<double>> known;
    auto& found = known[{model.word, turn}];
    if (!found.empty()) return found;
    const ModelTrial trial(model);
    for (std::size_t other = turn; other < turn + turns; ++other) {
        found = numbers(model, other);
        if (trial.each_matters(found)) return found;
    }
    return found = numbers(model, turn);
}

}  // namespace pelage::verify
