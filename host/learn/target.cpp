// See target.hpp.
#include "learn/target.hpp"

#include "core/error.hpp"
#include "learn/draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pelage::learn {

namespace {

constexpr std::size_t fewest_patches = 4;  // of a level, for its ranks to say anything
// Pixels around the torus from which patches may take, where the picture has them: enough for the smallest level.
constexpr std::size_t margin = 16;
constexpr std::size_t level_numbers = patch_numbers * patch_directions;  // of a set of directions
constexpr std::size_t colour_numbers = patch_side * patch_side;

using Direction = std::vector<double>;  // patch_numbers

// Every other direction takes no notice of how bright a patch is in each colour: only of what is in it.
Direction direction_of(std::int64_t seed, std::size_t which) {
    Direction direction(patch_numbers);
    for (std::size_t n = 0; n < patch_numbers; ++n)
        direction[n] = around_zero(seed, Draw::directions, which * (patch_numbers + 1) + n);
    for (std::size_t colour = 0; colour < picture_colours && which % 2 == 1; ++colour) {
        double sum = 0;
        for (std::size_t n = 0; n < colour_numbers; ++n) sum += direction[colour * colour_numbers + n];
        for (std::size_t n = 0; n < colour_numbers; ++n)
            direction[colour * colour_numbers + n] -= sum / static_cast<double>(colour_numbers);
    }
    double square = 0;
    for (const double number : direction) square += number * number;
    for (double& number : direction) number /= std::sqrt(square);
    return direction;
}

bool whole(const Window& window, std::size_t row, std::size_t column) {
    for (std::size_t n = 0; n < colour_numbers; ++n) {
        if (!window.inside[(row + n / patch_side) * window.side + column + n % patch_side]) return false;
    }
    return true;
}

// All patches that lie within the picture, half a colour's range below what they are: the state's colours are, too.
std::vector<Direction> patches_of(const Window& window) {
    std::vector<Direction> patches;
    for (std::size_t row = 0; row + patch_side <= window.side; ++row) {
        for (std::size_t column = 0; column + patch_side <= window.side; ++column) {
            if (!whole(window, row, column)) continue;
            Direction& patch = patches.emplace_back();
            for (std::size_t n = 0; n < patch_numbers; ++n) {
                const std::size_t place = n % colour_numbers;
                const std::size_t pixel = (row + place / patch_side) * window.side + column + place % patch_side;
                patch.push_back(window.values[n / colour_numbers][pixel] - 0.5);
            }
        }
    }
    return patches;
}

// Of many, evenly spread ones.
std::vector<Direction> thinned(std::vector<Direction> patches, std::size_t most) {
    if (patches.size() <= most) return patches;
    std::vector<Direction> few;
    for (std::size_t n = 0; n < most; ++n) few.push_back(patches[n * patches.size() / most]);
    return few;
}

// What patches have along each direction, in ascending order, as if there were `count` of them. along: the directions,
// [number of a patch][direction].
void add_ranked(const std::vector<Direction>& patches, const double* along, std::size_t count,
                std::vector<float>& ranked) {
    std::vector<std::vector<double>> seen(patch_directions);
    for (const Direction& patch : patches) {
        std::array<double, patch_directions> sums{};
        for (std::size_t n = 0; n < patch_numbers; ++n) {
            for (std::size_t d = 0; d < patch_directions; ++d) sums[d] += patch[n] * along[n * patch_directions + d];
        }
        for (std::size_t d = 0; d < patch_directions; ++d) seen[d].push_back(sums[d]);
    }
    for (std::vector<double>& one : seen) {
        std::ranges::sort(one);
        for (std::size_t rank = 0; rank < count; ++rank)
            ranked.push_back(static_cast<float>(one[(2 * rank + 1) * one.size() / (2 * count)]));
    }
}

using Levels = std::vector<std::vector<Direction>>;  // the patches of each

Levels levels_of(const Settings& settings, const Colours& picture, std::size_t rotation) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(rotation) / static_cast<double>(settings.shape.rotations);
    Window window =
        window_of(picture, settings.shape.side + 2 * margin, scale_of(settings, picture), angle, settings.wrap);
    Levels levels;
    for (std::size_t level = 0; level < pyramid_levels; ++level) {
        if (level > 0) window = halved(window);
        levels.push_back(thinned(patches_of(window), settings.shape.level_cells(level)));
        if (levels.back().size() < fewest_patches)
            throw Error(fmt::format(
                "of the picture, {} x {} pixels at {:.3g} a cell, too little lies within the torus of {} cells a side; "
                "give a larger picture, fewer --rotations, another --size, a smaller --scale, or --wrap",
                picture.columns, picture.rows, scale_of(settings, picture), settings.shape.side));
    }
    return levels;
}

// What repeats beyond its edges may be ever so small in cells: then there is nothing in it to learn.
void check_scale(const Settings& settings, const Colours& picture) {
    const double scale = scale_of(settings, picture);
    const auto shorter = static_cast<double>(std::min(picture.columns, picture.rows));
    if (!limits::scale.allows(scale))
        throw Error(
            fmt::format("a picture of {} x {} pixels comes to {:.3g} pixels a cell on a torus of {} cells a side, "
                        "and that is {}; --scale or --size can say otherwise",
                        picture.columns, picture.rows, scale, settings.shape.side, allowed(limits::scale)));
    if (shorter / scale >= static_cast<double>(patch_side)) return;
    throw Error(
        fmt::format("at --scale {:.3g} the picture, {} x {} pixels, is {:.3g} cells wide or high; {} are the least, "
                    "so that a patch of it can be seen",
                    scale, picture.columns, picture.rows, shorter / scale, patch_side));
}

}  // namespace

double scale_of(const Settings& settings, const Colours& picture) {
    if (settings.scale) return *settings.scale;
    return static_cast<double>(std::min(picture.columns, picture.rows)) / static_cast<double>(settings.shape.side);
}

LearningTask make_task(const Settings& settings, const Colours& picture) {
    check_scale(settings, picture);
    LearningTask task;
    task.shape = settings.shape;
    task.overflow = settings.overflow;
    task.memory = settings.memory;
    std::vector<double> along(direction_sets * pyramid_levels * level_numbers);
    for (std::size_t which = 0; which < direction_sets * pyramid_levels * patch_directions; ++which) {
        const Direction direction = direction_of(settings.seed, which);
        double* to = along.data() + which / patch_directions * level_numbers + which % patch_directions;
        for (std::size_t n = 0; n < patch_numbers; ++n) to[n * patch_directions] = direction[n];
    }
    for (const double number : along) task.directions.push_back(static_cast<float>(number));
    std::vector<Levels> turned;
    for (std::size_t rotation = 0; rotation < settings.shape.rotations; ++rotation)
        turned.push_back(levels_of(settings, picture, rotation));
    for (std::size_t set = 0; set < direction_sets; ++set) {
        for (const Levels& levels : turned) {
            for (std::size_t level = 0; level < pyramid_levels; ++level)
                add_ranked(levels[level], along.data() + (set * pyramid_levels + level) * level_numbers,
                           settings.shape.level_cells(level), task.ranked);
        }
    }
    return task;
}

}  // namespace pelage::learn
