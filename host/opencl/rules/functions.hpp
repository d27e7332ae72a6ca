// The kernel files of elementary functions.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace pelage {

// The files ("functions/exp.cl") that define the functions of these places in function_table(), in an order in which
// each comes after what it needs, and those of the parts. They come after common/prelude.cl; function NAME is `real
// pelage_NAME(real, ...)`.
std::vector<std::string> function_files(const std::set<std::size_t>& used, const std::vector<std::string>& parts = {});

}  // namespace pelage
