// Elementary functions by their places in function_table().
#pragma once

#include <cstddef>

namespace pelage::reference {

// Arguments in the order of FunctionFacts::parameters. T is float or double. Single precision works with subnormal
// numbers taken for 0 (core/subnormal.hpp); the results are the same where the processor is not told so.
template <class T>
T apply_function(std::size_t index, const T* arguments);

// For whole columns: compute_function() of core/functions.hpp.

}  // namespace pelage::reference
