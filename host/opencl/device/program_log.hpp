// What is kept of programs for those who look whether all of the kernels is tried (tests/coverage): with
// PELAGE_PROGRAMS_LOG=FOLDER in its environment a process leaves there the text of each program that it uses, and the
// name of each kernel that it launches.
#pragma once

#include "opencl/device/cl.hpp"

#include <string>

namespace pelage {

// FOLDER/HASH.cl; its first line is a comment with the options.
void log_program(const std::string& source, const std::string& options);
// FOLDER/NAME.launched, an empty file.
void log_launch(const cl::Kernel& kernel);

}  // namespace pelage
