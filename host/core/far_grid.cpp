// See far_grid.hpp.
#include "core/far_grid.hpp"

#include <algorithm>

namespace pelage {

FarGrid far_grid(std::size_t columns, std::size_t rows) {
    FarLevel level;
    level.side = std::max(columns, rows) <= 256 ? 8 : 32;
    level.columns = (columns + level.side - 1) / level.side;
    level.rows = (rows + level.side - 1) / level.side;
    FarGrid grid;
    grid.levels.push_back(level);
    while (level.columns > 2 || level.rows > 2) {
        level.first += level.columns * level.rows;
        level.side *= 2;
        level.columns = (level.columns + 1) / 2;
        level.rows = (level.rows + 1) / 2;
        grid.levels.push_back(level);
    }
    return grid;
}

}  // namespace pelage
