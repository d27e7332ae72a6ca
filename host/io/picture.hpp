// Pictures in memory, and PNG files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace pelage {

using Rgb = std::array<std::uint8_t, 3>;

struct Picture {
    Picture(std::size_t width, std::size_t height, Rgb fill = {255, 255, 255})
        : columns(width), rows(height), pixels(width * height, fill) {}

    std::size_t columns;
    std::size_t rows;
    std::vector<Rgb> pixels;  // row-major, top line first

    Rgb& at(std::size_t column, std::size_t line) { return pixels[line * columns + column]; }
    const Rgb& at(std::size_t column, std::size_t line) const { return pixels[line * columns + column]; }
};

// Every pixel becomes factor x factor pixels.
Picture enlarged(const Picture&, std::size_t factor);

// The factor that brings the shorter side to 400 pixels or more: at most 16, and the longer side stays below 8192.
std::size_t enlargement(std::size_t columns, std::size_t rows);

// 8 bits a channel; shades of grey alone are stored as such. Throws Error naming the file and the reason.
void write_png(const std::filesystem::path&, const Picture&);

}  // namespace pelage
