// The texts of kernels/**/*.cl, embedded at build time.
#pragma once

#include <map>
#include <string>

namespace pelage {

// File name relative to kernels/ ("lattice/step.cl", "models/turing.cl") -> text.
const std::map<std::string, std::string>& kernel_sources();

}  // namespace pelage
