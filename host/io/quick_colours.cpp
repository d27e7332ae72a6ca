// See quick_colours.hpp.
#include "io/quick_colours.hpp"

#include "io/frame_loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace pelage {
namespace {

constexpr double piece_margin = 0.02;  // of a piece: more than rounding moves a value
constexpr std::size_t stride = 512;    // values whose places are found at a time

}  // namespace

QuickColours::QuickColours(const Output& output, std::function<Word(const Rgb&)> form)
    : form_(std::move(form)), table_(pieces + 3) {
    const Palette palette(output.colormap);
    const auto count = static_cast<double>(pieces);
    std::vector<Rgb> colours(pieces + 2);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const double at = static_cast<double>(i) - 1;
        colours[i] = palette(at - piece_margin, count);
        table_[i] = form_(colours[i]);
        if (colours[i] != palette(at + 1 + piece_margin, count)) table_[i] |= mixed;
    }
    // Between stops each channel rises or falls: equal colours at the ends, and at a stop in between, are those of all.
    for (const ColourStop& stop : palette.stops()) {
        const auto place = static_cast<std::size_t>(stop.at * count) + 1;
        const Rgb there = palette(stop.at * count, count);
        for (std::size_t i = place - 1; i <= std::min(place + 1, pieces + 1); ++i) {
            if (colours[i] != there) table_[i] |= mixed;
        }
    }
    table_[nan_place] = form_(magenta);
    std::ranges::transform(palette.slots(), std::back_inserter(slots_), form_);
}

void QuickColours::draw(const Colours& colours, const float* values, std::size_t count, Word* to) const {
    const double low = colours.low();
    const double scale = static_cast<double>(pieces) / (colours.high() - low);
    if (colours.flat() || !std::isfinite(scale)) {
        std::transform(values, values + count, to, [&](float value) { return form_(colours(double{value})); });
        return;
    }
    // Single precision is twice as fast. It moves a place by 0.006 at most, and by what it makes of the low end.
    constexpr double largest = 1e37;
    const auto single_low = static_cast<float>(low);
    const auto single_scale = static_cast<float>(scale);
    const bool single = std::abs((low - double{single_low}) * scale) < piece_margin / 4 &&
                        std::isnormal(single_scale) && std::abs(low) < largest && std::abs(colours.high()) < largest;
    std::array<std::int32_t, stride> places;
    for (std::size_t begin = 0; begin < count; begin += stride) {
        const std::size_t some = std::min(stride, count - begin);
        if (single) {
            find_places(values + begin, some, Placing<float>{single_low, single_scale, pieces + 1, nan_place},
                        places.data());
        } else {
            find_places(values + begin, some, Placing<double>{low, scale, pieces + 1, nan_place}, places.data());
        }
        look_up(colours, values + begin, std::span(places).first(some), to + begin);
    }
}

void QuickColours::look_up(const Colours& colours, const float* values, std::span<const std::int32_t> places,
                           Word* to) const {
    const Word seen = look_up_words(table_.data(), places.data(), places.size(), to);
    if ((seen & mixed) != 0) compute_mixed(colours, values, places.size(), to);
}

void QuickColours::compute_mixed(const Colours& colours, const float* values, std::size_t count, Word* to) const {
    const Palette& palette = colours.palette();
    const double low = colours.low();
    const double range = colours.high() - low;
    float last = std::numeric_limits<float>::quiet_NaN();
    Word word = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if ((to[i] & mixed) == 0) continue;
        if (values[i] != last) {  // cells of a background are alike
            last = values[i];
            word = slots_.empty() ? form_(colours(double{last})) : slots_[palette.slot(double{last} - low, range)];
        }
        to[i] = word;
    }
}

ValueRange range_of(std::span<const float> values) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    std::array<float, finite_lanes> low, high;
    low.fill(infinite);
    high.fill(-infinite);
    const std::size_t rounds = values.size() / finite_lanes;
    widen_lanes(values.data(), rounds, low.data(), high.data());
    std::array<float, finite_lanes> rest;
    rest.fill(std::numeric_limits<float>::quiet_NaN());
    std::ranges::copy(values.subspan(rounds * finite_lanes), rest.begin());
    widen_lanes(rest.data(), 1, low.data(), high.data());
    ValueRange range;
    const float least = *std::ranges::min_element(low);
    const float most = *std::ranges::max_element(high);
    if (least <= most) range.widen({least, most});
    return range;
}

}  // namespace pelage
