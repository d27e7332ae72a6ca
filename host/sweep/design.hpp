// Which values parameters take in a sweep.
#pragma once

#include "core/parameter.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pelage::sweep {

inline constexpr std::size_t largest_tile_count = 1'000'000;

// A parameter and what it takes, each value as it would be written.
struct Axis {
    std::string name;
    std::vector<std::string> values;
};

struct Range {
    std::string name;
    double low = 0.0, high = 0.0;
    bool logarithmic = false;
};

// One tile: values for parameters, and which repetition of them it is.
struct Point {
    std::vector<Setting> settings;
    std::size_t replicate = 0;
    bool operator==(const Point&) const;
};

// NAME=A,B,C | NAME=LOW:HIGH:COUNT | NAME=log:LOW:HIGH:COUNT, ends included. Throws Error naming the word.
Axis parse_axis(const std::string& word);
// NAME=LOW:HIGH | NAME=log:LOW:HIGH. Throws Error naming the word.
Range parse_range(const std::string& word);

// All combinations, the first axis changing fastest, then all of them again for each further replicate. Throws Error
// for an axis that is given twice, and for more than largest_tile_count tiles.
std::vector<Point> grid(const std::vector<Axis>&, std::size_t replicates);

// `count` points within the ranges: independent ones, or with `latin` one in each of `count` equal parts of every range
// (McKay, Beckman & Conover 1979). The same seed draws the same.
std::vector<Point> samples(const std::vector<Range>&, std::size_t count, bool latin, std::uint64_t seed);

// A table: the first line names parameters, each further one is a point; fields are parted by commas. Throws Error
// with file and line.
std::vector<Point> read_points(const std::filesystem::path&);

}  // namespace pelage::sweep
