// See frame.hpp.
#include "io/frame.hpp"

#include "core/error.hpp"
#include "io/frame_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace pelage {
namespace {

// The pixels first .. last - 1 of the picture, for each pixel of the frame.
struct Stretch {
    std::size_t first = 0;
    std::size_t last = 1;
};

std::vector<Stretch> stretches(std::size_t from, std::size_t to) {
    std::vector<Stretch> result(to);
    for (std::size_t i = 0; i < to; ++i) {
        result[i].first = i * from / to;
        result[i].last = std::max(result[i].first + 1, (i + 1) * from / to);
    }
    return result;
}

// What of `length` pixels is seen in a frame: they begin at pixel `at` of it, or the first `skipped` are cut off.
struct Seen {
    std::size_t at, skipped, count;
};

Seen seen(std::size_t length, std::size_t frame) {
    if (length <= frame) return {(frame - length) / 2, 0, length};
    return {0, (length - frame) / 2, frame};
}

Rgb mean_of(const Picture& picture, const Stretch& columns, const Stretch& lines) {
    std::array<std::size_t, 3> sum{};
    for (std::size_t line = lines.first; line < lines.last; ++line) {
        for (std::size_t column = columns.first; column < columns.last; ++column) {
            for (std::size_t i = 0; i < 3; ++i) sum[i] += picture.at(column, line)[i];
        }
    }
    const std::size_t count = (columns.last - columns.first) * (lines.last - lines.first);
    Rgb mean;
    for (std::size_t i = 0; i < 3; ++i) mean[i] = static_cast<std::uint8_t>((sum[i] + count / 2) / count);
    return mean;
}

}  // namespace

std::size_t Scale::of(std::size_t length) const { return std::max<std::size_t>(1, length * to / from); }

Scale fitting_scale(std::size_t columns, std::size_t rows, std::size_t frame_columns, std::size_t frame_rows) {
    if (frame_columns * rows <= frame_rows * columns) return {frame_columns, columns};
    return {frame_rows, rows};
}

Picture framed(const Picture& picture, const Scale& scale, std::size_t frame_columns, std::size_t frame_rows) {
    const std::vector<Stretch> across = stretches(picture.columns, scale.of(picture.columns));
    const std::vector<Stretch> down = stretches(picture.rows, scale.of(picture.rows));
    const Seen columns = seen(across.size(), frame_columns);
    const Seen lines = seen(down.size(), frame_rows);
    const bool single = across.size() >= picture.columns && down.size() >= picture.rows;
    Picture frame(frame_columns, frame_rows);
    for (std::size_t j = 0; j < lines.count; ++j) {
        const Stretch& rows = down[lines.skipped + j];
        for (std::size_t i = 0; i < columns.count; ++i) {
            const Stretch& places = across[columns.skipped + i];
            frame.at(columns.at + i, lines.at + j) =
                single ? picture.at(places.first, rows.first) : mean_of(picture, places, rows);
        }
    }
    return frame;
}

std::uint32_t parts_word(const Rgb& rgb) {
    return std::uint32_t{rgb[0]} << high_part | std::uint32_t{rgb[1]} << middle_part |
           std::uint32_t{rgb[2]} << low_part;
}

std::uint32_t yuv_word(const Rgb& rgb) {
    std::uint32_t word = parts_word(rgb);
    to_yuv(&word, 1, &word);
    return word;
}

Yuv420::Yuv420(std::size_t columns, std::size_t rows, std::string& to) : columns_(columns) {
    if (columns % 2 != 0 || rows % 2 != 0) {
        throw Error(fmt::format("{} x {} pixels make no frame; both must be even", columns, rows));
    }
    to.resize(columns * rows + columns * rows / 2);
    bright_ = reinterpret_cast<std::uint8_t*>(to.data());
    blue_ = bright_ + columns * rows;
    red_ = blue_ + columns * rows / 4;
}

void Yuv420::put(std::size_t line, const std::uint32_t* above, const std::uint32_t* below) {
    take_high_parts(above, columns_, bright_ + line * columns_);
    take_high_parts(below, columns_, bright_ + (line + 1) * columns_);
    const std::size_t quarter = line / 2 * (columns_ / 2);
    mean_parts(above, below, columns_ / 2, blue_ + quarter, red_ + quarter);
}

void write_yuv420(const Picture& picture, std::string& to) {
    Yuv420 planes(picture.columns, picture.rows, to);
    std::vector<std::uint32_t> words(2 * picture.columns);
    for (std::size_t line = 0; line < picture.rows; line += 2) {
        const auto* from = picture.pixels.data() + line * picture.columns;
        std::transform(from, from + words.size(), words.begin(), [](const Rgb& rgb) { return parts_word(rgb); });
        to_yuv(words.data(), words.size(), words.data());
        planes.put(line, words.data(), words.data() + picture.columns);
    }
}

}  // namespace pelage
