// Pictures and arrays as initial states.
#include "io/field.hpp"
#include "core/error.hpp"
#include "io/exr.hpp"
#include "io/npy.hpp"
#include "scratch.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <half.h>
#include <png.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

namespace {

struct PngKind {
    int depth;
    int colour;
    int interlace = PNG_INTERLACE_NONE;
};

void append(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

// A PNG picture made with libpng from its lines, top line first.
std::string make_png(unsigned columns, const PngKind& kind, std::vector<std::string> lines,
                     const std::vector<png_color>& palette = {}) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, [](png_structp) {});
    png_set_IHDR(png, info, columns, static_cast<unsigned>(lines.size()), kind.depth, kind.colour, kind.interlace, 0,
                 0);
    if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    std::vector<png_bytep> rows;
    rows.reserve(lines.size());
    for (auto& line : lines) rows.push_back(reinterpret_cast<png_bytep>(line.data()));
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

std::vector<double> values_of(const std::string& png, const std::string& channel = "") {
    return parse_png(png, channel, "a.png").values;
}

// R, G, B of 2 x 2 pixels as HALF, Z as FLOAT; the data window begins at (-3, 5).
void make_exr(const std::filesystem::path& path) {
    Imf::Header header(Imath::Box2i({-3, 5}, {-2, 6}), Imath::Box2i({-3, 5}, {-2, 6}));
    const std::vector<half> colours[3] = {{half(1), half(0), half(0.5), half(0.25)},
                                          {half(0), half(1), half(0.5), half(0.25)},
                                          {half(0), half(0), half(0.5), half(0.25)}};
    const std::vector<float> depth{1.f, 2.f, 3.f, 4.f};
    const auto place = [](const void* pixels, std::size_t size) {
        return static_cast<char*>(const_cast<void*>(pixels)) - static_cast<std::ptrdiff_t>(size) * (-3 + 5 * 2);
    };
    Imf::FrameBuffer buffer;
    for (int i = 0; i < 3; ++i) {
        const std::string name(1, "RGB"[i]);
        header.channels().insert(name, Imf::Channel(Imf::HALF));
        buffer.insert(name, Imf::Slice(Imf::HALF, place(colours[i].data(), 2), 2, 4));
    }
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    buffer.insert("Z", Imf::Slice(Imf::FLOAT, place(depth.data(), 4), 4, 8));
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(2);
}

}  // namespace

TEST_CASE("a picture's lowest line becomes row 0") {
    const auto png = make_png(2, {8, PNG_COLOR_TYPE_GRAY}, {"\x01\x02", "\x33\x99", "\xff\xcc"});

    const auto field = parse_png(png, "", "a.png");

    CHECK(field.columns == 2);
    CHECK(field.rows == 3);
    CHECK(field.values == std::vector<double>{1.0, 0.8, 0.2, 0.6, 1 / 255.0, 2 / 255.0});
}

TEST_CASE("all depths and colour types of PNG are scaled to 0..1") {
    using namespace std::string_literals;
    const PngKind rgba{8, PNG_COLOR_TYPE_RGB_ALPHA};
    const auto colour = make_png(1, rgba, {"\xff\x33\x00\x66"s});
    const auto deep = make_png(1, {16, PNG_COLOR_TYPE_RGB}, {"\xff\xff\x12\x34\x00\x01"s});
    const auto grey_alpha = make_png(1, {16, PNG_COLOR_TYPE_GRAY_ALPHA}, {"\x80\x00\x00\xff"s});
    const auto bits = make_png(8, {1, PNG_COLOR_TYPE_GRAY}, {"\xa5"});
    const auto nibbles = make_png(2, {4, PNG_COLOR_TYPE_GRAY}, {"\xf3"});
    const auto palette =
        make_png(4, {2, PNG_COLOR_TYPE_PALETTE}, {"\x1b"}, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {51, 51, 51}});

    CHECK(values_of(colour, "R") == std::vector<double>{1.0});
    CHECK(values_of(colour, "G") == std::vector<double>{0.2});
    CHECK(values_of(colour, "B") == std::vector<double>{0.0});
    CHECK(values_of(colour, "A") == std::vector<double>{0.4});
    CHECK(values_of(colour)[0] == Approx(0.2126 + 0.7152 * 0.2).epsilon(1e-12));
    CHECK(values_of(deep, "G") == std::vector<double>{0x1234 / 65535.0});
    CHECK(values_of(deep, "B") == std::vector<double>{1 / 65535.0});
    CHECK(values_of(grey_alpha) == std::vector<double>{0x8000 / 65535.0});
    CHECK(values_of(grey_alpha, "B") == values_of(grey_alpha));
    CHECK(values_of(grey_alpha, "A") == std::vector<double>{0xff / 65535.0});
    CHECK_THAT(test::error_of([&] { values_of(deep, "A"); }),
               Contains("no channel 'A'") && Contains("R, G, B, and no A"));
    CHECK_THAT(test::error_of([&] { values_of(bits, "A"); }), Contains("no channel 'A'"));
    CHECK_THAT(test::error_of([&] { values_of(colour, "L"); }), Contains("R, G, B and A"));
    CHECK(values_of(bits) == std::vector<double>{1, 0, 1, 0, 0, 1, 0, 1});
    CHECK(values_of(nibbles) == std::vector<double>{1.0, 0.2});
    CHECK(values_of(palette, "R") == std::vector<double>{1, 0, 0, 0.2});
    CHECK(values_of(palette) == std::vector<double>{0.2126, 0.7152, 0.0722, 0.2});
}

TEST_CASE("an interlaced picture is the same picture") {
    std::vector<std::string> lines;
    for (int line = 0; line < 13; ++line) {
        lines.emplace_back();
        for (int i = 0; i < 11; ++i) lines.back() += static_cast<char>(line * 17 + i * 5);
    }

    const auto plain = values_of(make_png(11, {8, PNG_COLOR_TYPE_GRAY}, lines));
    const auto interlaced = values_of(make_png(11, {8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7}, lines));

    CHECK(plain.size() == 143);
    CHECK(plain == interlaced);
}

TEST_CASE("EXR fields: a named channel, luminance, lowest line first, HALF and FLOAT") {
    const Scratch scratch;
    const auto path = scratch / "a.exr";
    make_exr(path);

    const auto depth = read_field(path, "Z");
    const auto green = read_field(path, "G");
    const auto light = read_field(path, "");

    CHECK(depth->columns == 2);
    CHECK(depth->rows == 2);
    CHECK(depth->values == std::vector<double>{3, 4, 1, 2});
    CHECK(green->values == std::vector<double>{0.5, 0.25, 0, 1});
    CHECK(light->values == std::vector<double>{0.5, 0.25, 0.2126, 0.7152});
    CHECK_THAT(test::error_of([&] { read_field(path, "X"); }), Contains("no channel 'X'") && Contains("B, G, R, Z"));
}

namespace {

// Channel i holds i + 1 everywhere, so that a value tells where it comes from.
std::string exr_with(const Scratch& scratch, const std::vector<std::string>& names, const Attributes& texts = {}) {
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < names.size(); ++i) values.emplace_back(4, static_cast<double>(i + 1));
    std::vector<ExrChannel> channels;
    for (std::size_t i = 0; i < names.size(); ++i) channels.push_back({names[i], values[i]});
    write_exr(scratch / "a.exr", 2, 2, channels, texts);
    return test::get(scratch / "a.exr");
}

}  // namespace

TEST_CASE("without a channel's name an EXR field is luminance or the one channel that is not alpha") {
    const Scratch scratch;
    const auto value = [&](const std::vector<std::string>& names) {
        return parse_exr(exr_with(scratch, names), "", "a.exr").values.at(0);
    };
    const double light = 0.2126 * 1 + 0.7152 * 2 + 0.0722 * 3;

    CHECK(value({"Y", "A"}) == 1);
    CHECK(value({"R", "A"}) == 1);
    CHECK(value({"height"}) == 1);
    CHECK(value({"A"}) == 1);
    CHECK(value({"Y", "RY", "BY"}) == 1);
    CHECK(value({"R", "G", "B"}) == Approx(light).epsilon(1e-12));
    CHECK(value({"R", "G", "B", "A", "Z"}) == Approx(light).epsilon(1e-12));
    CHECK(value({"layer.R", "layer.G", "layer.B", "layer.A"}) == Approx(light).epsilon(1e-12));
    CHECK(value({"render.left.Y", "render.left.A"}) == 1);
    CHECK(value({"R", "G", "B", "mask.R", "mask.G", "mask.B"}) == Approx(light).epsilon(1e-12));
}

TEST_CASE("an EXR field that could be several channels is refused with their names") {
    const Scratch scratch;
    const auto problem = [&](const std::vector<std::string>& names, const Attributes& texts = {}) {
        const auto bytes = exr_with(scratch, names, texts);
        return test::error_of([&] { parse_exr(bytes, "", "a.exr"); });
    };

    CHECK_THAT(problem({"U", "V"}), Contains("a.exr") && Contains("U, V") && Contains("'channel U'"));
    CHECK_THAT(problem({"R", "G"}), Contains("G, R"));
    CHECK_THAT(problem({"one.R", "one.G", "one.B", "two.Y"}), Contains("one.R, two.Y"));
    CHECK_THAT(problem({"U", "V", "Y"}, {{exr_chemicals, "U V"}}), Contains("'channel U'"));
}

TEST_CASE("the only chemical of a picture of ours is meant, not what other programs show of it") {
    const Scratch scratch;

    CHECK(parse_exr(exr_with(scratch, {"U", "Y"}, {{exr_chemicals, "U"}}), "", "a.exr").values[0] == 1);
    CHECK(parse_exr(exr_with(scratch, {"U", "Y"}, {{exr_chemicals, "U"}}), "Y", "a.exr").values[0] == 2);
}

TEST_CASE("tiled EXR pictures are refused in words") {
    const Scratch scratch;
    const auto path = scratch / "tiled.exr";
    {
        Imf::Header header(4, 4);
        header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
        header.setTileDescription(Imf::TileDescription(4, 4));
        const std::vector<float> pixels(16);
        Imf::FrameBuffer buffer;
        buffer.insert("Z",
                      Imf::Slice(Imf::FLOAT, const_cast<char*>(reinterpret_cast<const char*>(pixels.data())), 4, 16));
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writeTile(0, 0);
    }

    CHECK_THAT(test::error_of([&] { read_field(path, ""); }), Contains("tiled.exr") && Contains("only scan lines"));
}

TEST_CASE("row 0 of an array stays row 0") {
    const Scratch scratch;
    write_npy(scratch / "a.npy", {2, 3}, std::vector<double>{1, 2, 3, 4, 5, 6});
    write_npy(scratch / "line.npy", {3}, std::vector<double>{1, 2, 3});
    write_npy(scratch / "none.npy", {0, 3}, std::vector<double>{});

    const auto field = read_field(scratch / "a.npy", "");

    CHECK(field->columns == 3);
    CHECK(field->rows == 2);
    CHECK(field->values == std::vector<double>{1, 2, 3, 4, 5, 6});
    CHECK_THAT(test::error_of([&] { read_field(scratch / "a.npy", "R"); }), Contains("no channel 'R'"));
    CHECK_THAT(test::error_of([&] { read_field(scratch / "line.npy", ""); }), Contains("1 dimension;"));
    CHECK_THAT(test::error_of([&] { read_field(scratch / "none.npy", ""); }), Contains("no cells"));
}

TEST_CASE("fields must be finite, of a known kind, and there") {
    const Scratch scratch;
    write_npy(scratch / "nan.npy", {2, 2}, std::vector<double>{1, 2, 3, std::nan("")});
    write_npy(scratch / "inf.npy", {1, 1}, std::vector<double>{std::numeric_limits<double>::infinity()});
    test::put(scratch / "text.png", "hello");
    test::put(scratch / "empty.png", "");
    const auto problem = [&](const std::string& name, const std::string& channel = "") {
        return test::error_of([&] { read_field(scratch / name, channel); });
    };

    write_exr(scratch / "nan.exr", 2, 2, {{"U", std::vector<double>{0, std::nan(""), 0, 0}}}, {});
    write_exr(scratch / "inf.exr", 1, 1, {{"U", std::vector{1e6}, ExrType::half}}, {});
    write_exr(scratch / "other.exr", 1, 1, {{"U", std::vector{1.0}}, {"V", std::vector{std::nan("")}}}, {});

    CHECK_THAT(problem("nan.exr"), Contains("nan.exr") && Contains("row 0, column 1"));
    CHECK_THAT(problem("inf.exr"), Contains("inf") && Contains("must be finite"));
    CHECK(problem("other.exr", "U").empty());
    CHECK_THAT(problem("nan.npy"), Contains("row 1, column 1"));
    CHECK_THAT(problem("inf.npy"), Contains("inf") && Contains("must be finite"));
    CHECK_THAT(problem("text.png"), Contains("neither a PNG nor an EXR picture nor an .npy array"));
    CHECK_THAT(problem("empty.png"), Contains("neither"));
    CHECK_THAT(problem("missing.png"), Contains("missing.png") && Contains("No such file"));
    const auto png = make_png(1, {8, PNG_COLOR_TYPE_GRAY}, {"\x01"});
    CHECK_THAT(test::error_of([&] { parse_png(png, "Z", "a.png"); }), Contains("no channel 'Z'"));
}

TEST_CASE("a PNG picture cut anywhere is an error, and no change crashes") {
    const auto plain = make_png(3, {8, PNG_COLOR_TYPE_RGB}, {"abcdefghi", "jklmnopqr", "stuvwxyz!"});
    const auto interlaced =
        make_png(3, {8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7}, {"abcdefghi", "jklmnopqr", "stuvwxyz!"});
    const auto parse = [](auto bytes) { parse_png(bytes, "", "a.png"); };

    for (const auto& whole : {plain, interlaced}) {
        CHECK(test::error_of([&] { parse(std::string_view(whole)); }).empty());
        CHECK(test::accepted_beginnings(whole, parse) == 0);
        CHECK(test::accepted_changes(whole, parse) < whole.size() / 2);
    }
}

TEST_CASE("an EXR picture cut anywhere is an error, and no change crashes") {
    const Scratch scratch;
    make_exr(scratch / "a.exr");
    const auto whole = test::get(scratch / "a.exr");
    const auto parse = [](auto bytes) { parse_exr(bytes, "", "a.exr"); };

    CHECK(test::error_of([&] { parse(std::string_view(whole)); }).empty());
    CHECK(test::accepted_beginnings(whole, parse) == 0);
    test::accepted_changes(whole, parse);
}

TEST_CASE("absurd sizes are refused before there is memory for them") {
    auto png = make_png(1, {8, PNG_COLOR_TYPE_GRAY}, {"\x01"});
    png[16] = png[20] = '\x7f';  // 2130706433 x 2130706433, with a right checksum
    const auto crc = [](std::string_view bytes) {
        std::uint32_t sum = 0xffffffffu;
        for (const char c : bytes) {
            sum ^= static_cast<unsigned char>(c);
            for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1u) != 0 ? 0xedb88320u : 0u);
        }
        return ~sum;
    };
    auto sum = crc(std::string_view(png).substr(12, 17));
    for (std::size_t i = 0; i < 4; ++i) png[32 - i] = static_cast<char>(sum >> 8 * i);
    auto long_strip = png;
    long_strip.replace(16, 8, std::string("\x00\x00\xb0\x00\x00\x00\xb0\x00", 8));  // 45056 x 45056 in 67 bytes
    sum = crc(std::string_view(long_strip).substr(12, 17));
    for (std::size_t i = 0; i < 4; ++i) long_strip[32 - i] = static_cast<char>(sum >> 8 * i);

    const auto black = make_png(4096, {1, PNG_COLOR_TYPE_GRAY}, std::vector(4096, std::string(512, '\0')));

    CHECK(black.size() < 4096);
    CHECK(values_of(black) == std::vector<double>(std::size_t{4096} * 4096));
    CHECK_THAT(test::error_of([&] { values_of(png); }), Contains("at most 2147483647 cells"));
    CHECK_THAT(test::error_of([&] { values_of(long_strip); }), Contains("says 45056 x 45056 but has only"));
}
