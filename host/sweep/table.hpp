// sweep.csv: a row a tile, written as soon as the tile is finished.
#pragma once

#include "sweep/design.hpp"
#include "sweep/tile.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pelage::sweep {

class Table {
public:
    // `names`: of the parameters that vary.
    Table(std::filesystem::path, std::vector<std::string> names);

    // Takes up the rows that are there, by tile; one that is cut off or of another sweep does not count.
    void take_up(const std::vector<Point>&);

    bool has(std::size_t tile) const { return rows_.contains(tile); }
    std::size_t size() const { return rows_.size(); }
    std::string verdict(std::size_t tile) const;  // of a tile that it has

    // The row of a tile, as add() takes it. Any thread.
    std::string row(std::size_t tile, const Point&, std::int64_t seed, const TileResult&, double seconds) const;
    // Adds the row to the file. Throws Error where it cannot be written.
    void add(std::size_t tile, std::string row);

    // Writes the file anew, in the order of tiles, aside first.
    void sort() const;

private:
    std::string heading() const;
    std::string beginning(std::size_t tile, const Point&) const;

    std::filesystem::path path_;
    std::vector<std::string> names_;
    std::map<std::size_t, std::string> rows_;
};

}  // namespace pelage::sweep
