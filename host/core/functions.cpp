// See functions.hpp; the tables themselves are made by cmake/WriteFunctions.cmake.
#include "core/functions.hpp"

#include <algorithm>

namespace pelage {

std::optional<std::size_t> function_named(std::string_view name) {
    const auto& table = function_table();
    const auto found = std::ranges::find(table, name, &FunctionFacts::name);
    if (found == table.end()) return {};
    return static_cast<std::size_t>(found - table.begin());
}

}  // namespace pelage
