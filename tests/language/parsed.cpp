// See parsed.hpp.
#include "language/parsed.hpp"

#include "language/error_case.hpp"
#include "language/parse.hpp"

namespace test {

pelage::Experiment parsed(const std::string& text) { return pelage::parse_experiment(text, "t.pex", "/nowhere"); }

pelage::Experiment parsed_on_grid(const std::string& text) { return parsed(grid + text); }

pelage::Experiment parsed_on_matrix(const std::string& text) { return parsed(matrix + text); }

pelage::Rule rule_on_grid(const std::string& text) { return parsed_on_grid(text).rules.at(0); }

pelage::Rule rule_on_matrix(const std::string& text) { return parsed_on_matrix(text).rules.at(0); }

}  // namespace test
