// Small experiments built by hand, for tests of the core.
#pragma once

#include "core/experiment.hpp"

namespace test {

// U and V on a columns x rows matrix with the Turing model of Malheiros & Walter.
inline pelage::Experiment turing_matrix(std::size_t columns, std::size_t rows) {
    using namespace pelage;
    Experiment experiment;
    experiment.chemicals = {{"U", {}, false, nullptr}, {"V", {}, false, nullptr}};
    experiment.phases = {{"", 0, 0.01, {Bounds{}, Bounds{}}, {std::nullopt, std::nullopt}}};
    experiment.prepattern = {UseChemical{0, Spread{4, 1}, Spread{5, 0}}, UseChemical{1, Spread{4, 1}, Spread{1, 0}},
                             CreateMatrix{columns, rows, Boundary::wrap, 0, 0}};
    Rule rule;
    rule.action = React{model_named("turing"), {0, 1}, Operand::number(1), {Operand::number(16), Operand::number(12)}};
    experiment.rules = {rule};
    experiment.outputs = {Output{}};
    return experiment;
}

}  // namespace test
