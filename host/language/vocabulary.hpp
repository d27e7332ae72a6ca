// The words of rules, for whoever writes experiments and must leave none out.
#pragma once

#include <string_view>
#include <vector>

namespace pelage::language {

std::vector<std::string_view> words_of_actions();      // "react", "change", ...
std::vector<std::string_view> words_of_quantities();   // "NEIGHBORS", "AGE", ...
std::vector<std::string_view> words_of_conditions();   // "always", "if", "probability"
std::vector<std::string_view> words_of_comparisons();  // "==", ..., "in"

}  // namespace pelage::language
