// From a picture to what a learner compares with.
#include "learn/target.hpp"
#include "core/error.hpp"
#include "io/picture.hpp"
#include "reference/learn/loss.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using namespace pelage;
using namespace pelage::learn;

namespace {

// Stripes that repeat every 8 pixels along x.
Colours stripes(std::size_t columns, std::size_t rows) {
    Colours picture{columns, rows, {}};
    for (auto& values : picture.values) {
        for (std::size_t n = 0; n < columns * rows; ++n)
            values.push_back(0.5 + 0.4 * std::sin(2 * std::numbers::pi * static_cast<double>(n % columns) / 8));
    }
    return picture;
}

Settings settings_for(std::size_t rotations) {
    Settings settings;
    settings.shape = {32, 1, 4, 8, rotations};
    return settings;
}

std::string refusal(const std::string& file) {
    try {
        (void)read_colours(file);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a window of a picture is the picture where they are of one size") {
    const Colours picture = stripes(32, 32);
    const Window window = window_of(picture, 32, 1, 0, false);
    for (std::size_t pixel = 0; pixel < 1024; pixel += 7)
        CHECK(window.values[1][pixel] == Approx(picture.values[1][pixel]));
    CHECK(std::ranges::count(window.inside, true) == 1024);
    // A quarter of a turn: what lay to the right lies below or above.
    const Window turned = window_of(picture, 32, 1, std::numbers::pi / 2, false);
    CHECK(turned.values[0][3 * 32 + 10] == Approx(turned.values[0][3 * 32 + 20]));
    CHECK(turned.values[0][3 * 32 + 10] == Approx(turned.values[0][11 * 32 + 10]).margin(1e-9));
    // Between the axes the corners lie beyond the picture, but not of one that goes on.
    const double eighth = std::numbers::pi / 4;
    CHECK_FALSE(window_of(picture, 32, 1, eighth, false).inside[0]);
    CHECK(window_of(picture, 32, 1, eighth, false).inside[16 * 32 + 16]);
    CHECK(window_of(picture, 32, 1, eighth, true).inside[0]);
    CHECK(window_of(picture, 16, 2, 0, false).values[0][5] ==
          Approx((picture.values[0][10] + picture.values[0][11]) / 2));
}

TEST_CASE("ranked values ascend, directions have length 1, every other one has mean 0 in each colour") {
    const LearningTask task = make_task(settings_for(2), stripes(48, 32));
    const std::size_t all = task.shape.level_begin(pyramid_levels) * patch_directions;
    REQUIRE(task.ranked.size() == all * direction_sets * 2);
    CHECK(std::is_sorted(task.ranked.begin(), task.ranked.begin() + 1024));
    REQUIRE(task.directions.size() == direction_sets * pyramid_levels * patch_numbers * patch_directions);
    for (std::size_t direction = 0; direction < 4; ++direction) {
        double square = 0, mean = 0;
        for (std::size_t n = 0; n < patch_numbers; ++n) {
            const auto one = static_cast<double>(task.directions[n * patch_directions + direction]);
            square += one * one;
            if (n < 49) mean += one;
        }
        CHECK(square == Approx(1));
        CHECK((std::abs(mean) < 1e-5) == (direction % 2 == 1));
    }
}

TEST_CASE("a state that is the picture has next to no loss, and turned it has the rotation's") {
    const Colours picture = stripes(32, 32);
    Settings settings = settings_for(4);
    settings.wrap = true;
    const LearningTask task = make_task(settings, picture);
    std::vector<double> state(task.shape.sample(), 0.0), slopes(state.size());
    const auto loss_of = [&](double angle) {
        const Window window = window_of(picture, 32, 1, angle, true);
        for (std::size_t colour = 0; colour < 3; ++colour) {
            for (std::size_t n = 0; n < 1024; ++n) state[colour * 1024 + n] = window.values[colour][n] - 0.5;
        }
        return reference::sample_loss(task, 0, state.data(), slopes.data());
    };
    const auto straight = loss_of(0), across = loss_of(std::numbers::pi / 2);
    CHECK(straight.rotation % 2 == 0);
    CHECK(across.rotation % 2 == 1);
    std::ranges::fill(state, 0.0);
    const double flat = reference::sample_loss(task, 0, state.data(), slopes.data()).value;
    CHECK(straight.value < 0.05 * flat);
    CHECK(across.value < 0.05 * flat);
}

TEST_CASE("what is no picture to learn from is refused in a sentence") {
    const test::Folder folder;
    write_png(folder / "thin.png", Picture(200, 6));
    CHECK_THAT(refusal(folder.write("text.png", "no picture")), Catch::Contains("is not a PNG picture"));
    CHECK_THAT(refusal(folder.write("cut.png", "\x89PNG\r\n\x1a\nabc")), Catch::Contains("cut.png"));
    CHECK_THAT(refusal((folder / "thin.png").string()), Catch::Contains("200 x 6; at least 7 pixels"));
    CHECK_THAT(refusal((folder / "none.png").string()), Catch::Contains("none.png"));
    CHECK_THROWS_WITH(make_task(
                          [] {
                              Settings settings = settings_for(1);
                              settings.scale = 1;
                              return settings;
                          }(),
                          stripes(12, 12)),
                      Catch::Contains("give a larger picture"));
}
