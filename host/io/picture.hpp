// Pictures in memory, and PNG files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace pelage {

using Rgb = std::array<std::uint8_t, 3>;
using DeepRgb = std::array<std::uint16_t, 3>;

template <class Pixel>
struct PictureOf {
    PictureOf(std::size_t width, std::size_t height, Pixel fill)
        : columns(width), rows(height), pixels(width * height, fill) {}
    PictureOf(std::size_t width, std::size_t height) : PictureOf(width, height, white()) {}

    static Pixel white() {
        Pixel pixel;
        pixel.fill(static_cast<typename Pixel::value_type>(-1));
        return pixel;
    }

    std::size_t columns;
    std::size_t rows;
    std::vector<Pixel> pixels;  // row-major, top line first

    Pixel& at(std::size_t column, std::size_t line) { return pixels[line * columns + column]; }
    const Pixel& at(std::size_t column, std::size_t line) const { return pixels[line * columns + column]; }
};

using Picture = PictureOf<Rgb>;
using DeepPicture = PictureOf<DeepRgb>;                       // 16 bits a channel
using GreyPicture = PictureOf<std::array<std::uint16_t, 1>>;  // 16 bits, shades of grey

DeepPicture deepened(const Picture&);  // the same colours
Picture shallow(const DeepPicture&);   // the nearest ones

// Every pixel becomes factor x factor pixels.
template <class Pixel>
PictureOf<Pixel> enlarged(const PictureOf<Pixel>& picture, std::size_t factor) {
    PictureOf<Pixel> result(picture.columns * factor, picture.rows * factor);
    for (std::size_t line = 0; line < result.rows; ++line) {
        for (std::size_t column = 0; column < result.columns; ++column) {
            result.at(column, line) = picture.at(column / factor, line / factor);
        }
    }
    return result;
}

// The factor that brings the shorter side to 400 pixels or more: at most 16, and the longer side stays below 8192.
std::size_t enlargement(std::size_t columns, std::size_t rows);

// RGB of 8 bits a channel, of 16, or grey of 16, whatever the colours are. Throws Error naming the file and the reason.
void write_png(const std::filesystem::path&, const Picture&);
void write_png(const std::filesystem::path&, const DeepPicture&);
void write_png(const std::filesystem::path&, const GreyPicture&);

}  // namespace pelage
