// Tables on the terminal.
#pragma once

#include <string>
#include <vector>

namespace pelage::app {

using TableLine = std::vector<std::string>;

// One line a line, as many columns as the first has; each begins where the widest text before it lets it, the last is
// as it is.
std::string aligned(const std::vector<TableLine>& lines);

}  // namespace pelage::app
