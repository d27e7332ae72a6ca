// Comparisons of whole numbers as OpenCL C: without a rounding to real.
#pragma once

#include "core/experiment.hpp"
#include "opencl/rules/numbers.hpp"

#include <cstdint>
#include <string>

namespace pelage {

// As written in C: "<=".
const char* symbol(Comparison);

// The whole numbers of 32 bits for which `w COMPARISON number` holds: those from low to high, none where low is above
// high; or, where not `inside`, all others. `inside` depends on the comparison alone. `number` may have a fraction or
// lie outside what 32 bits hold.
struct WholeRange {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    bool inside = true;
};
WholeRange whole_range(Comparison, double number);

// That truth as a mask; `whole` is the text of a uintv, or of a uint where it is uniform. The range's ends are
// parameters of the program.
std::string emit_whole_test(const std::string& whole, bool uniform, Comparison, double number, Numbers&);

// The comparison that holds with its sides exchanged: a < b is b > a.
Comparison exchanged(Comparison);

}  // namespace pelage
