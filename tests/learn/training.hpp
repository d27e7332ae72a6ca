// A training of a second: its picture, and the words that call it.
#pragma once

#include "io/picture.hpp"
#include "support/process.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace test {

// Round spots on a torus.
inline void write_spots(const std::filesystem::path& path) {
    pelage::Picture picture(32, 32);
    for (std::size_t n = 0; n < 1024; ++n) {
        const double x = std::cos(static_cast<double>(n % 32) * 0.785398),
                     y = std::cos(static_cast<double>(n / 32) * 0.785398);
        const auto shade = static_cast<std::uint8_t>(128 + 60 * x * y);
        picture.at(n % 32, n / 32) = {shade, shade, 40};
    }
    pelage::write_png(path, picture);
}

inline const std::vector<std::string> quick{"--size", "32", "--chemicals", "4", "--hidden",     "8",   "--batch", "2",
                                            "--pool", "8",  "--rotations", "1", "--iterations", "4:9", "--wrap"};

inline std::vector<std::string> training_words(const Folder& folder, const std::string& model,
                                               std::vector<std::string> more) {
    std::vector<std::string> words{"learn", (folder / "spots.png").string(), "--out", (folder / model).string()};
    words.insert(words.end(), quick.begin(), quick.end());
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace test
