// Numbers in messages.
#pragma once

#include <string>

namespace pelage {

// The shortest decimal that reads back to the same number: of a number that a float holds, in single precision.
std::string digits(double);

}  // namespace pelage
