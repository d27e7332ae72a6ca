// Parsing good experiments in tests.
#pragma once

#include "core/experiment.hpp"

#include <string>
#include <variant>

namespace test {

// Parses `text` as t.pex in a folder that is not there.
pelage::Experiment parsed(const std::string& text);

// The same with chemicals U and V and a 10 x 10 sqr_grid before it.
pelage::Experiment parsed_on_grid(const std::string& text);

// The same with chemicals U and V and a 20 x 10 matrix before it.
pelage::Experiment parsed_on_matrix(const std::string& text);

// The only rule of `text` on the grid (matrix), and its action.
pelage::Rule rule_on_grid(const std::string& text);
pelage::Rule rule_on_matrix(const std::string& text);

template <class Action>
Action action_on_grid(const std::string& text) {
    return std::get<Action>(rule_on_grid(text).action);
}

}  // namespace test
