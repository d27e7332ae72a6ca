// An experiment's parameters as `pelage check --parameters` lists them.
#pragma once

#include "core/experiment.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace pelage::app {

// One line each: NAME VALUE (default D) from LOW to HIGH: MEANING. A sentence where there are none.
std::string parameters_text(const Experiment&);

// {"experiment": its source, "parameters": [{"name", "value", "default", "low" and "high" (null: no bound), "meaning",
// "line"}]}
nlohmann::ordered_json parameters_json(const Experiment&);

}  // namespace pelage::app
