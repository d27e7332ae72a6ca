// The whole state of a tissue between two iterations, as a structure of arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pelage {

// Values are held as double whatever the precision of the run: a float survives the trip unchanged.
// Cells are in id order; on a lattice id = row * columns + column, the bottom row being row 0; in a volume
// id = (layer * rows + row) * columns + column.
struct Snapshot {
    std::uint64_t iteration = 0;
    std::size_t columns = 0;  // 0 for free cells
    std::size_t rows = 0;
    std::size_t layers = 0;  // of a volume; 0 for every other space
    double origin_x = 0.0;   // centre of a lattice
    double origin_y = 0.0;

    std::vector<std::vector<double>> conc;      // [chemical][cell]
    std::vector<std::vector<double>> diff;      // [chemical][cell], diffusion rates
    std::vector<std::vector<double>> mappings;  // [mapping][cell]
    std::vector<double> x, y;                   // centres, in units of cell radius
    std::vector<double> polarity_x, polarity_y;
    std::vector<std::uint32_t> birth;      // iteration at which the cell came to be; never after `iteration`
    std::vector<std::int32_t> neighbours;  // as counted in the previous iteration
    std::vector<std::uint8_t> fixed;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> mirrors;  // ids of mirror pairs

    // What spatial sorting goes on from: the ids in its matrix, row after row, as it was last sorted. Cells that were
    // born since are not in it. Empty with every other search, and where nothing has been sorted yet.
    std::vector<std::uint32_t> order;

    bool lattice() const { return columns != 0 && layers == 0; }
    bool volume() const { return layers != 0; }
    bool on_grid() const { return columns != 0; }  // cells in columns and rows: a lattice or a volume
    std::size_t cells() const { return x.size(); }
};

}  // namespace pelage
