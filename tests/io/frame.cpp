// Frames of films: pictures brought to one size, and colours that are looked up instead of computed.
#include "io/frame.hpp"
#include "io/quick_colours.hpp"

#include "core/error.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace pelage;

namespace {

std::uint32_t word_of(const Rgb& rgb) {
    return std::uint32_t{rgb[0]} << 16 | std::uint32_t{rgb[1]} << 8 | std::uint32_t{rgb[2]};
}

Output drawn_with(const std::string& name, std::vector<ColourStop> stops = {}) {
    Output output;
    output.colormap.name = name;
    output.colormap.stops = std::move(stops);
    return output;
}

void check_equal(const Output& output, const ValueRange& range, const std::vector<float>& values) {
    const Colours colours(output, range);
    std::vector<std::uint32_t> found(values.size());
    QuickColours(output, word_of).draw(colours, values.data(), values.size(), found.data());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < values.size(); ++i) differing += found[i] != word_of(colours(double{values[i]}));
    INFO(output.colormap.name << " from " << range.low << " to " << range.high);
    CHECK(differing == 0);
}

// Numbers all over the range and beyond, next to its ends and to where the colours of slots end, and no numbers.
std::vector<float> many_values(const ValueRange& range) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    std::vector<float> values{0.0F, -0.0F, infinite, -infinite, std::numeric_limits<float>::quiet_NaN()};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-0.1, 1.1);
    const double width = range.high - range.low;
    for (int i = 0; i < 100'000; ++i) values.push_back(static_cast<float>(range.low + width * anywhere(random)));
    for (int slot = 0; slot <= 99; ++slot) {
        float value = static_cast<float>(range.low + width * slot / 99);
        for (int i = 0; i < 3; ++i) value = std::nextafter(value, -infinite);
        for (int i = 0; i < 7; ++i) values.push_back(value = std::nextafter(value, infinite));
    }
    return values;
}

Picture numbered(std::size_t columns, std::size_t rows) {
    Picture picture(columns, rows);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i].fill(static_cast<std::uint8_t>(10 * i));
    return picture;
}

std::string reds(const Picture& picture) {
    std::string text;
    for (std::size_t line = 0; line < picture.rows; ++line) {
        for (std::size_t column = 0; column < picture.columns; ++column)
            text += std::to_string(picture.at(column, line)[0]) + (column + 1 < picture.columns ? " " : "\n");
    }
    return text;
}

}  // namespace

TEST_CASE("colours that are looked up are those that are computed") {
    const std::vector<ColourStop> stripes{
        {0, {0, 0, 0}}, {0.25, {255, 0, 0}}, {0.5, {0, 255, 0}}, {1, {255, 255, 255}}};
    const std::vector<ColourStop> spike{{0.5, {9, 9, 9}}, {0.500004, {255, 255, 255}}, {0.500008, {9, 9, 9}}};
    const auto output =
        GENERATE_COPY(drawn_with("heat"), drawn_with("inferno"), drawn_with("gray"), drawn_with("viridis"),
                      drawn_with("striped", stripes), drawn_with("gradient", stripes), drawn_with("stops", stripes),
                      drawn_with("stops", spike), drawn_with("stops", {{0.3, {1, 2, 3}}}));
    for (const ValueRange& range :
         {ValueRange{0, 1}, ValueRange{-3, 4.7}, ValueRange{1000, 1000.01}, ValueRange{2, 2}, ValueRange{0, 1e-5},
          ValueRange{1e-40, 2e-40}, ValueRange{-3e38, 3e38}, ValueRange{}}) {
        check_equal(output, range, many_values(range.empty() ? ValueRange{0, 1} : range));
    }
    Output ranged = output;
    ranged.range = {{0.25, 0.75}};
    check_equal(ranged, {}, many_values({0, 1}));
    ranged.range = {{0.75, 0.25}};
    check_equal(ranged, {}, many_values({0, 1}));
}

TEST_CASE("the range of floats is that of the finite ones") {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto range = [](const std::vector<float>& values) { return range_of(std::span(values)); };
    CHECK(range({}).empty());
    CHECK(range({nan, infinite, -infinite}).empty());
    std::vector<float> values(100, 2.5F);
    values[3] = nan, values[40] = infinite, values[41] = -infinite, values[97] = -1, values[99] = 7;
    CHECK(range(values) == ValueRange{-1, 7});
    values[97] = values[99] = nan;
    CHECK(range(values) == ValueRange{2.5, 2.5});
}

TEST_CASE("a picture is enlarged by nearest neighbours, reduced to means, and put in the middle of a white frame") {
    CHECK(reds(framed(numbered(2, 2), {2, 1}, 4, 4)) == "0 0 10 10\n0 0 10 10\n20 20 30 30\n20 20 30 30\n");
    CHECK(reds(framed(numbered(4, 2), {1, 2}, 2, 2)) == "25 45\n255 255\n");
    CHECK(reds(framed(numbered(2, 1), {1, 1}, 4, 3)) == "255 255 255 255\n255 0 10 255\n255 255 255 255\n");
    CHECK(reds(framed(numbered(5, 1), {1, 1}, 3, 1)) == "10 20 30\n");
    CHECK(reds(framed(numbered(2, 1), {3, 2}, 4, 1)) == "0 0 10 255\n");
    CHECK(reds(framed(numbered(3, 3), {1, 9}, 1, 1)) == "40\n");
}

TEST_CASE("the scale that fits fills one side of the frame and not more") {
    for (const auto& [columns, rows] : {std::pair(300, 200), std::pair(7, 1000), std::pair(5000, 4999)}) {
        const auto c = static_cast<std::size_t>(columns), r = static_cast<std::size_t>(rows);
        const Scale scale = fitting_scale(c, r, 640, 480);
        CHECK(scale.of(c) <= 640);
        CHECK(scale.of(r) <= 480);
        CHECK((scale.of(c) == 640 || scale.of(r) == 480));
    }
}

TEST_CASE("a frame with an odd side is refused") {
    std::string bytes;
    CHECK_THROWS_WITH(write_yuv420(numbered(3, 2), bytes), "3 x 2 pixels make no frame; both must be even");
}
