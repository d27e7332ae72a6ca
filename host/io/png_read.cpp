// PNG pictures as fields; see field.hpp. libpng reports errors by longjmp: no object with a destructor may live in a
// function between its setjmp and the calls that can jump, so buffers are made by the callers.
#include "core/error.hpp"
#include "io/field.hpp"

#include <fmt/format.h>
#include <png.h>
#include <array>
#include <csetjmp>
#include <cstring>

namespace pelage {
namespace {

struct Source {
    const char* at = nullptr;
    std::size_t left = 0;
    std::array<char, 128> message{};
};

void on_read_error(png_structp png, png_const_charp text) {
    auto* source = static_cast<Source*>(png_get_error_ptr(png));
    std::strncpy(source->message.data(), text, source->message.size() - 1);
    png_longjmp(png, 1);
}

void on_read_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep to, std::size_t count) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (count > source->left) png_error(png, "it ends too early");
    std::memcpy(to, source->at, count);
    source->at += count;
    source->left -= count;
}

struct PngReader {
    explicit PngReader(std::string_view bytes) : source{bytes.data(), bytes.size(), {}} {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_read_error, on_read_warning);
        if (png != nullptr) info = png_create_info_struct(png);
    }
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    Source source;
    png_structp png = nullptr;
    png_infop info = nullptr;
    int passes = 1;
};

bool read_header(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_read_fn(reader.png, &reader.source, on_read);
    png_read_info(reader.png, reader.info);
    return true;
}

bool begin_rows(PngReader& reader) {  // makes buffers of the header's width
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_expand(reader.png);  // palettes to RGB, few bits to 8, transparency to alpha
    reader.passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_row(PngReader& reader, png_bytep row) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_row(reader.png, row, nullptr);
    return true;
}

bool read_end(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_end(reader.png, nullptr);
    return true;
}

// One pixel's value from its samples, all scaled to 0..1.
class Picker {
public:
    Picker(const PngReader& reader, const std::string& channel, const std::string& name)
        : channels_(png_get_channels(reader.png, reader.info)),
          bytes_(png_get_bit_depth(reader.png, reader.info) / 8u),
          wanted_(channel.empty() ? 'L' : channel[0]) {
        const bool alpha = channels_ % 2 == 0;
        if (channel.empty() || channel == "R" || channel == "G" || channel == "B" || (alpha && channel == "A")) return;
        throw Error(
            fmt::format("'{}' has no channel '{}'; it has R, G, B{}", name, channel, alpha ? " and A" : ", and no A"));
    }

    std::size_t pixel_bytes() const { return channels_ * bytes_; }

    double operator()(const png_byte* pixel) const {
        const bool colour = channels_ >= 3;
        switch (wanted_) {
            case 'A':
                return sample(pixel, channels_ - 1);
            case 'R':
                return sample(pixel, 0);
            case 'G':
                return sample(pixel, colour ? 1 : 0);
            case 'B':
                return sample(pixel, colour ? 2 : 0);
            default:
                return colour ? luminance(sample(pixel, 0), sample(pixel, 1), sample(pixel, 2)) : sample(pixel, 0);
        }
    }

private:
    double sample(const png_byte* pixel, std::size_t index) const {
        const png_byte* at = pixel + index * bytes_;
        return bytes_ == 1 ? at[0] / 255.0 : (at[0] * 256 + at[1]) / 65535.0;
    }

    std::size_t channels_;
    std::size_t bytes_;
    char wanted_;
};

[[noreturn]] void fail(const PngReader& reader, const std::string& name) {
    throw Error(fmt::format("'{}' is a corrupted PNG picture: {}", name, reader.source.message.data()));
}

}  // namespace

Field parse_png(std::string_view bytes, const std::string& channel, const std::string& name) {
    PngReader reader(bytes);
    if (reader.info == nullptr) throw Error(fmt::format("'{}' cannot be read: libpng cannot start", name));
    if (!read_header(reader)) fail(reader, name);
    Field field{png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info), {}};
    check_picture_size(field.columns, field.rows, field.rows * png_get_rowbytes(reader.png, reader.info), bytes.size(),
                       name);
    if (!begin_rows(reader)) fail(reader, name);
    const Picker pick(reader, channel, name);

    // An interlaced picture is read in several passes over all its rows, others row by row.
    const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
    const bool interlaced = reader.passes > 1;
    std::vector<png_byte> rows(row_bytes * (interlaced ? field.rows : 1));
    field.values.resize(field.columns * field.rows);
    for (int pass = 0; pass < reader.passes; ++pass) {
        for (std::size_t line = 0; line < field.rows; ++line) {
            png_bytep row = rows.data() + (interlaced ? line * row_bytes : 0);
            if (!read_row(reader, row)) fail(reader, name);
            if (pass + 1 < reader.passes) continue;
            double* out = field.values.data() + (field.rows - 1 - line) * field.columns;
            for (std::size_t column = 0; column < field.columns; ++column)
                out[column] = pick(row + column * pick.pixel_bytes());
        }
    }
    if (!read_end(reader)) fail(reader, name);
    return field;
}

}  // namespace pelage
