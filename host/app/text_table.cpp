// See text_table.hpp.
#include "app/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace pelage::app {

std::string aligned(const std::vector<TableLine>& lines) {
    std::vector<std::size_t> widths(lines.empty() ? 0 : lines.front().size());
    for (const TableLine& line : lines) {
        for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    }
    std::string text;
    for (const TableLine& line : lines) {
        for (std::size_t i = 0; i + 1 < widths.size(); ++i) text += fmt::format("{:<{}}  ", line[i], widths[i]);
        text += line.back() + "\n";
    }
    return text;
}

}  // namespace pelage::app
