// PNG files, enlargement and size.
#include "io/picture.hpp"
#include "core/error.hpp"
#include "io/field.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>
#include <string>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

TEST_CASE("a PNG picture has the pixels that were drawn") {
    const Scratch scratch;
    Picture picture(3, 2, {0, 51, 255});
    picture.at(2, 0) = {102, 0, 1};

    write_png(scratch / "a.png", picture);

    const auto red = read_field(scratch / "a.png", "R");
    CHECK(red->columns == 3);
    CHECK(red->rows == 2);
    CHECK(red->values == std::vector<double>{0, 0, 0, 0, 0, 0.4});  // the top line is the highest row
    CHECK(read_field(scratch / "a.png", "G")->values == std::vector<double>{0.2, 0.2, 0.2, 0.2, 0.2, 0});
    CHECK(read_field(scratch / "a.png", "B")->values == std::vector<double>{1, 1, 1, 1, 1, 1 / 255.0});
    CHECK(test::get(scratch / "a.png")[25] == 2);  // colour type: RGB
}

namespace {

int bits_of(const std::string& png) { return png[24]; }
int colour_type_of(const std::string& png) { return png[25]; }  // 0: grey, 2: RGB

}  // namespace

TEST_CASE("a picture is RGB whatever its colours are") {
    const Scratch scratch;
    Picture picture(2, 1, {51, 51, 51});
    picture.at(1, 0) = {255, 255, 255};

    write_png(scratch / "a.png", picture);

    CHECK(bits_of(test::get(scratch / "a.png")) == 8);
    CHECK(colour_type_of(test::get(scratch / "a.png")) == 2);
    CHECK(read_field(scratch / "a.png", "")->values == std::vector<double>{0.2, 1.0});
}

TEST_CASE("pictures of 16 bits keep them, in colours and in grey") {
    const Scratch scratch;
    DeepPicture colours(2, 1, {0x0102, 0xfffe, 0x8000});
    colours.at(1, 0) = {0, 1, 0xffff};
    GreyPicture grey(2, 1, {0x1234});
    grey.at(1, 0) = {0xffff};

    write_png(scratch / "a.png", colours);
    write_png(scratch / "b.png", grey);

    CHECK(bits_of(test::get(scratch / "a.png")) == 16);
    CHECK(colour_type_of(test::get(scratch / "a.png")) == 2);
    CHECK(read_field(scratch / "a.png", "R")->values == std::vector<double>{0x0102 / 65535.0, 0});
    CHECK(read_field(scratch / "a.png", "G")->values == std::vector<double>{0xfffe / 65535.0, 1 / 65535.0});
    CHECK(bits_of(test::get(scratch / "b.png")) == 16);
    CHECK(colour_type_of(test::get(scratch / "b.png")) == 0);
    CHECK(read_field(scratch / "b.png", "")->values == std::vector<double>{0x1234 / 65535.0, 1.0});
    CHECK(deepened(Picture(1, 1, {0, 51, 255})).at(0, 0) == DeepRgb{0, 51 * 257, 65535});
}

TEST_CASE("enlarging repeats pixels") {
    Picture picture(2, 1, {1, 2, 3});
    picture.at(1, 0) = {4, 5, 6};

    const auto large = enlarged(picture, 3);

    CHECK(large.columns == 6);
    CHECK(large.rows == 3);
    for (std::size_t line = 0; line < 3; ++line) {
        CHECK(large.at(2, line) == Rgb{1, 2, 3});
        CHECK(large.at(3, line) == Rgb{4, 5, 6});
    }
}

TEST_CASE("small fields are enlarged to 400 pixels, within limits") {
    CHECK(enlargement(100, 100) == 4);
    CHECK(enlargement(130, 390) == 4);
    CHECK(enlargement(399, 1000) == 2);
    CHECK(enlargement(400, 400) == 1);
    CHECK(enlargement(4096, 4096) == 1);
    CHECK(enlargement(3, 5) == 16);
    CHECK(enlargement(1, 4000) == 2);
    CHECK(enlargement(1, 100000) == 1);
}

TEST_CASE("PNG pictures that cannot be written leave nothing behind") {
    const Scratch scratch;
    const Picture picture(10, 10);

    CHECK_THAT(test::error_of([&] { write_png("/dev/full", picture); }), Contains("No space left on device"));
    CHECK_THAT(test::error_of([&] { write_png(scratch / "none/a.png", picture); }), Contains("none/a.png"));
    CHECK_THAT(test::error_of([&] { write_png(scratch / "a.png", Picture(0, 0)); }), Contains("0 x 0"));
    CHECK(scratch.names().empty());
}
