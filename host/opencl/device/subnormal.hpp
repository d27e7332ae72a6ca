// What a device makes of subnormal numbers: -cl-denorms-are-zero only permits it to take them for 0.
#pragma once

#include "opencl/device/session.hpp"

#include <string>
#include <vector>

namespace pelage {

// The kinds of arithmetic, of a session in single precision, in which subnormal numbers are kept ("products"); empty
// where all of them are 0, as core/subnormal.hpp has it.
std::vector<std::string> keeps_subnormals(const Session&);

// Where the device gives something else than 0 or the subnormal number itself, what it gives; else empty.
std::string subnormal_fault(const Session&);

// Where device and processor do not treat subnormal numbers alike, a sentence about how far their results are equal
// all the same; else empty, in double precision too.
std::string subnormal_difference(const Session&);

}  // namespace pelage
