// The error codes of the OpenCL standard, and what a user must be told about them.
#pragma once

#include "faults.hpp"

#include <string>
#include <vector>

namespace test {

// All errors of OpenCL 1.2, and that of a loader without platforms.
const std::vector<cl_int>& standard_codes();

// The sentence says what went wrong when the call `name` failed with that code: the code's name and the device's, or
// what the call stands for.
bool tells(const std::string& sentence, const std::string& name, cl_int code);

}  // namespace test
