// Colormaps as published, named ones, and what lies outside.
#include "io/colour.hpp"
#include "core/error.hpp"
#include "io/brush.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using Catch::Matchers::Contains;
using namespace pelage;

namespace {

constexpr Rgb red{255, 0, 0};
constexpr Rgb green{0, 255, 0};
constexpr Rgb blue{0, 0, 255};

Output output(const std::string& name, std::vector<ColourStop> stops = {}) { return {0, {name, std::move(stops)}, {}}; }

Output ranged(Output output, double low, double high) {
    output.range = {low, high};
    return output;
}

Colours over(Output output, double low, double high) { return {ranged(std::move(output), low, high), ValueRange{}}; }

bool near(const Rgb& a, const Rgb& b, int tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(a[i] - b[i]) > tolerance) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("heat runs from blue over cyan, green and yellow to red in 100 slots") {
    const auto heat = over(output("heat"), 0, 99);

    CHECK(heat(0) == blue);
    CHECK(heat(99) == red);
    CHECK(near(heat(24.75 + 0.5), {0, 255, 255}, 8));
    CHECK(near(heat(49.5 + 0.5), green, 8));
    CHECK(near(heat(74.25 + 0.5), {255, 255, 0}, 10));
    CHECK(heat(98.999) == heat(98));  // int(99 * fraction)
    CHECK(heat(98.999) != red);
    for (int slot = 1; slot < 100; ++slot) {
        INFO(slot);
        CHECK(heat(slot) != heat(slot - 1));
    }
}

TEST_CASE("striped holds a slot's colour, gradient goes over to the next one") {
    const std::vector<ColourStop> stops{{20 / 99.0, red}, {60 / 99.0, {0, 200, 100}}};
    const auto striped = over(output("striped", stops), 0, 99);
    const auto gradient = over(output("gradient", stops), 0, 99);

    for (const double slot : {0, 10, 20, 40, 59}) CHECK(striped(slot + 0.01) == red);
    for (const double slot : {60, 80, 98}) CHECK(striped(slot + 0.01) == Rgb{0, 200, 100});
    CHECK(striped(99) == Rgb{0, 200, 100});

    for (const double slot : {0, 10, 20}) CHECK(gradient(slot + 0.01) == red);
    CHECK(gradient(30.01) == Rgb{191, 50, 25});
    CHECK(gradient(40.01) == Rgb{128, 100, 50});
    for (const double slot : {60, 80, 98}) CHECK(gradient(slot + 0.01) == Rgb{0, 200, 100});
    CHECK(gradient(99) == Rgb{0, 200, 100});
}

TEST_CASE("colours of slots may come in any order, and one is enough") {
    const auto striped = over(output("striped", {{1.0, green}, {0.0, red}}), 0, 99);
    const auto plain = over(output("gradient", {{0.5, blue}}), 0, 99);

    CHECK(striped(98.9) == red);
    CHECK(striped(99) == green);
    CHECK(plain(0) == blue);
    CHECK(plain(99) == blue);
}

TEST_CASE("every map keeps its end colours outside its range") {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<ColourStop> stops{{0.25, red}, {0.75, blue}};
    for (const auto& name : {"heat", "gradient", "striped", "inferno", "gray", "stops"}) {
        const auto colours = over(output(name, stops), 0, 1);
        INFO(name);
        CHECK(colours(-0.001) == colours(0));
        CHECK(colours(-infinity) == colours(0));
        CHECK(colours(1.001) == colours(1));
        CHECK(colours(infinity) == colours(1));
        CHECK(colours(0) != colours(1));
        CHECK(colours(std::nan("")) == magenta);
    }
    CHECK(over(output("stops", stops), 0, 1)(0.1) == red);
    CHECK(over(output("stops", stops), 0, 1)(0.5) == Rgb{128, 0, 128});
    CHECK(over(output("gray"), 1, 0)(0.25) == Rgb{191, 191, 191});  // a range may run downwards
    CHECK(over(output("heat"), 1, 0)(0.9) == over(output("heat"), 0, 1)(0.1));
}

TEST_CASE("a range that is given is drawn however small it is") {
    for (const auto& name : {"heat", "inferno"}) {
        const auto colours = over(output(name), 0, 1e-6);
        INFO(name);
        CHECK(colours(0) == over(output(name), 0, 1)(0));
        CHECK(colours(1e-6) == over(output(name), 0, 1)(1));
    }
}

TEST_CASE("without a given range equal values are grey, and with a slotted map nearly equal ones, as published") {
    const std::vector<double> flat{0.3, 0.30005};
    const std::vector<double> steep{0.3, 0.3002};
    const std::vector<double> small{1.0, 1.0 + 1e-9};
    const std::vector<double> equal{1.0, 1.0};

    CHECK(Colours(output("heat"), flat)(0.3) == grey);
    CHECK(Colours(output("heat"), steep)(0.3) == blue);
    CHECK(Colours(output("heat"), steep)(0.3002) == red);
    CHECK(Colours(output("heat"), ValueRange{0.3, 0.30005})(0.3) == grey);
    CHECK(Colours(output("gray"), small)(1.0) == Rgb{0, 0, 0});
    CHECK(Colours(output("gray"), small)(1.0 + 1e-9) == Rgb{255, 255, 255});
    CHECK(Colours(output("gray"), equal)(1.0) == grey);
}

TEST_CASE("16 bits have the colours of 8, and linear maps those between") {
    const auto deep = over(output("gray"), 0, 1);
    const auto heat = over(output("heat"), 0, 1);

    CHECK(deep.deep(0) == DeepRgb{0, 0, 0});
    CHECK(deep.deep(1) == DeepRgb{65535, 65535, 65535});
    CHECK(deep.deep(0.5)[0] == 32768);
    CHECK(deep.deep(0.5001) != deep.deep(0.5));
    CHECK(heat.deep(1) == DeepRgb{65535, 0, 0});
    CHECK(heat.deep(std::nan("")) == DeepRgb{65535, 0, 65535});
}

TEST_CASE("named maps meet their originals within 2 %") {
    const auto inferno = over(output("inferno"), 0, 255);
    const auto viridis = over(output("viridis"), 0, 255);
    const auto magma = over(output("magma"), 0, 255);

    // Entries 0, 64, 100, 192, 255 of the published tables.
    CHECK(near(inferno(0), {0, 0, 4}, 5));
    CHECK(near(inferno(64), {87, 16, 110}, 5));
    CHECK(near(inferno(192), {249, 142, 9}, 6));
    CHECK(near(inferno(255), {252, 255, 164}, 5));
    CHECK(near(viridis(0), {68, 1, 84}, 5));
    CHECK(near(viridis(128), {33, 145, 140}, 5));
    CHECK(near(viridis(255), {253, 231, 37}, 5));
    CHECK(near(magma(64), {81, 18, 124}, 5));
    CHECK(near(magma(128), {183, 55, 121}, 5));
    CHECK(near(magma(255), {252, 253, 191}, 5));
}

TEST_CASE("the range is that of the finite values, a NaN is magenta") {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double> values{std::nan(""), -2, 6, infinity, -infinity};
    const std::vector<double> none{std::nan("")};

    const Colours colours(output("viridis"), values);
    const Colours nothing(output("viridis"), none);

    CHECK(colours.low() == -2);
    CHECK(colours.high() == 6);
    CHECK(colours(values[0]) == magenta);
    CHECK(nothing(0.0) == grey);
    CHECK(nothing(none[0]) == magenta);
}

TEST_CASE("a rendered lattice shows row 0 at the bottom") {
    const std::vector<double> values{0, 1, 2, 3, 4, 5};

    const auto picture = render(values, 3, 2, output("gray"));

    CHECK(picture.columns == 3);
    CHECK(picture.rows == 2);
    CHECK(picture.at(0, 1) == Rgb{0, 0, 0});
    CHECK(picture.at(2, 1) == Rgb{102, 102, 102});
    CHECK(picture.at(0, 0) == Rgb{153, 153, 153});
    CHECK(picture.at(2, 0) == Rgb{255, 255, 255});
}

TEST_CASE("colormaps that mean nothing are refused in words") {
    const auto problem = [](const Output& wanted) { return test::error_of([&] { Colours(wanted, ValueRange{}); }); };

    CHECK_THAT(problem(output("rainbow")), Contains("'rainbow'") && Contains("inferno"));
    CHECK_THAT(problem(output("striped")), Contains("'striped' has no colours"));
    CHECK_THAT(problem(output("stops", {{1.5, red}})), Contains("1.5") && Contains("0 to 1"));
    CHECK_THAT(problem(output("stops", {{std::nan(""), red}})), Contains("nan"));
    CHECK_THAT(test::error_of([] { render(std::vector<double>(5), 3, 2, Output{}); }), Contains("5 values"));
}
