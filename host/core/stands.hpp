// Where a part of an experiment's text stands, for messages about what is found out after parsing.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace pelage {

// "SOURCE:LINE:COLUMN", in characters from 1, of the first place in that line where `part` stands; "SOURCE:LINE" where
// it does not.
std::string where_stands(const Experiment&, std::size_t line, std::string_view part);

}  // namespace pelage
