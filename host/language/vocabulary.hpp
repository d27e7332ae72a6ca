// Words of the language, for whoever writes experiments and must leave none out.
#pragma once

#include <string_view>
#include <vector>

namespace pelage::language {

std::vector<std::string_view> words_of_actions();      // "react", "change", ...
std::vector<std::string_view> words_of_quantities();   // "NEIGHBORS", "AGE", ...
std::vector<std::string_view> words_of_chemicals();    // those that take one in expressions: "diff", "laplacian", ...
std::vector<std::string_view> words_of_conditions();   // "always", "if", "probability"
std::vector<std::string_view> words_of_comparisons();  // "==", ..., "in"
std::vector<std::string_view> words_of_stencils();     // "moore", ...
std::vector<std::string_view> words_of_boundaries();   // "no-flux", ...

}  // namespace pelage::language
