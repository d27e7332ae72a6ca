// Which of the kernels that failed is likely at fault, and which fail because they use it.
#pragma once

#include "verify/report.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace pelage::verify {

struct Dependence {
    std::string_view kernel;  // as Check has it
    std::vector<std::string_view> uses;
};

// All kernels, each after those that it uses.
const std::vector<Dependence>& dependences();

// Kernels with a check that is not passed, none of whose own kernels, used directly or not, has one.
std::vector<std::string> likely_roots(const std::vector<Result>&);

// What failed or is mistrusted: first that of likely roots, last what uses most.
std::vector<Result> failures(const std::vector<Result>&);

// "likely at fault: scan; what uses it fails, too: sort, neighbour search"; empty where nothing failed.
std::string causes_text(const std::vector<Result>&);

}  // namespace pelage::verify
