// Functions of OpenCL C and GLSL in terms of the experiment language's.
#pragma once

#include "import/term.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace pelage::imports {

// Empty where the function, with so many arguments, is not known here.
std::optional<TermRef> c_function(std::string_view name, const std::vector<TermRef>& arguments);

// M_PI and its like.
std::optional<TermRef> c_constant(std::string_view name);

}  // namespace pelage::imports
