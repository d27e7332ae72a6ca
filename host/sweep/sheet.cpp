// See sheet.hpp.
#include "sweep/sheet.hpp"

#include "io/brush.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace pelage::sweep {

Layout layout(const std::vector<Axis>& axes, std::size_t tiles, std::size_t across) {
    if (!axes.empty()) {
        across = axes.front().values.size();
        return {across, (tiles + across - 1) / across, true};
    }
    if (across == 0) across = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(tiles))));
    across = std::min(across, tiles);
    return {across, (tiles + across - 1) / across, false};
}

namespace {

ValueRange common_range(const std::vector<TilePicture>& tiles, const Output& output) {
    if (output.range) return {(*output.range)[0], (*output.range)[1]};
    ValueRange range;
    for (const TilePicture& tile : tiles) range.widen(range_of(tile.values));
    return range.empty() ? ValueRange{0.0, 1.0} : range;  // no tile has a number
}

// One, or three of `rgb`.
std::vector<std::span<const double>> columns_of(const TilePicture& tile) {
    const std::span<const double> all(tile.values);
    const std::size_t cells = tile.columns * tile.rows;
    std::vector<std::span<const double>> columns;
    for (std::size_t at = 0; at < all.size(); at += cells) columns.push_back(all.subspan(at, cells));
    return columns;
}

void paste(const Picture& tile, std::size_t left, std::size_t top, std::size_t rows, Picture& picture) {
    const std::size_t lower = top + rows;  // the first line below the tile's place
    for (std::size_t line = 0; line < tile.rows; ++line) {
        for (std::size_t column = 0; column < tile.columns; ++column) {
            const std::size_t x = left + column, y = lower - tile.rows + line;
            if (x < picture.columns && y < picture.rows) picture.at(x, y) = tile.at(column, line);
        }
    }
}

// Where a tile has no picture: it could not be run, or has not been yet.
Picture crossed_out(std::size_t columns, std::size_t rows) {
    constexpr Rgb paper{240, 240, 240}, pen{170, 170, 170};
    Picture picture(columns, rows);
    std::ranges::fill(picture.pixels, paper);
    const std::size_t longer = std::max(columns, rows);
    for (std::size_t i = 0; i < longer; ++i) {
        const std::size_t x = i * columns / longer, y = i * rows / longer;
        picture.at(x, y) = picture.at(columns - 1 - x, y) = pen;
    }
    return picture;
}

}  // namespace

Mosaic mosaic(const std::vector<TilePicture>& tiles, const Layout& layout, const Output& output, std::size_t least) {
    Mosaic made;
    std::size_t columns = 0, rows = 0;
    for (const TilePicture& tile : tiles) {
        if (tile.values.empty()) continue;
        columns = std::max(columns, tile.columns);
        rows = std::max(rows, tile.rows);
    }
    if (columns == 0) return made;
    const std::size_t factor = std::max<std::size_t>(1, least / std::max(columns, rows));
    made.tile_columns = columns * factor;
    made.tile_rows = rows * factor;
    made.range = common_range(tiles, output);
    made.picture = Picture(layout.across * (made.tile_columns + gap) - gap, layout.down * (made.tile_rows + gap) - gap);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const TilePicture& tile = tiles[i];
        const std::size_t row = i / layout.across, line = layout.from_below ? layout.down - 1 - row : row;
        const auto put = [&](const Picture& picture) {
            paste(picture, i % layout.across * (made.tile_columns + gap), line * (made.tile_rows + gap), made.tile_rows,
                  made.picture);
        };
        if (tile.values.empty()) {
            put(crossed_out(made.tile_columns, made.tile_rows));
            continue;
        }
        const Brush brush(output, columns_of(tile), made.range);
        put(enlarged(render(brush, tile.columns, tile.rows), factor));
    }
    return made;
}

}  // namespace pelage::sweep
