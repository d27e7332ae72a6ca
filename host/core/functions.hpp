// The table of elementary functions: what the first lines of kernels/functions/*.cl state. Each function has the same
// bits in the reference and on every device.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

struct FunctionFacts {
    std::string name;                     // as written in the language, and of the file in kernels/functions
    std::vector<std::string> parameters;  // as the language's page names them; none: a part of other functions
    std::vector<std::string> needs;       // the files that must come before this one
};

// Every function there is, by the alphabet.
const std::vector<FunctionFacts>& function_table();

// The files that functions are made of and that are none of their own.
const std::vector<FunctionFacts>& part_table();

// The place of a function in the table; nothing where there is none of that name.
std::optional<std::size_t> function_named(std::string_view name);

// out[i] of columns[0][i], columns[1][i], ... for i < count, as the reference computes it (it is defined in
// reference/rules/functions.cpp); T is float or double. Single precision works with subnormal numbers taken for 0
// (core/subnormal.hpp); the results are the same where the processor is not told so. out may be one of the columns.
template <class T>
void compute_function(std::size_t index, const T* const* columns, std::size_t count, T* out);

}  // namespace pelage
