// Comparisons of whole numbers as OpenCL C: without a rounding to real.
#pragma once

#include "core/experiment.hpp"

#include <string>

namespace pelage {

// As written in C: "<=".
const char* symbol(Comparison);

// Truth of `whole COMPARISON number` for a whole number of 32 bits, as a mask: `whole` is the text of a uintv, `number`
// may have a fraction or lie outside what 32 bits hold.
std::string emit_whole_test(const std::string& whole, Comparison, double number);

// The comparison that holds with its sides exchanged: a < b is b > a.
Comparison exchanged(Comparison);

}  // namespace pelage
