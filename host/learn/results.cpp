// See results.hpp.
#include "learn/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace pelage::learn {

namespace {

constexpr std::size_t gap = 4;           // pixels between pictures, before they are enlarged
constexpr std::size_t most_samples = 4;  // that are shown
constexpr std::size_t least_side = 128;  // of a picture, to be seen

std::uint8_t shade(double value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(std::isfinite(value) ? value : 0.0, 0.0, 1.0)));
}

template <class Value>  // of a colour in a pixel, the lowest row being the first
void paint(Picture& picture, std::size_t left, std::size_t side, const Value& value) {
    for (std::size_t pixel = 0; pixel < side * side; ++pixel) {
        Rgb& to = picture.at(left + pixel % side, side - 1 - pixel / side);
        for (std::size_t colour = 0; colour < picture_colours; ++colour) to[colour] = shade(value(colour, pixel));
    }
}

}  // namespace

Network network_of(const LearningShape& shape, const Learned<float>& learned) {
    const auto part = [&](std::size_t begin, std::size_t end) {
        return std::vector<double>(learned.weights.begin() + static_cast<std::ptrdiff_t>(begin),
                                   learned.weights.begin() + static_cast<std::ptrdiff_t>(end));
    };
    return make_network(shape.chemicals, shape.hidden, part(0, shape.bias()), part(shape.bias(), shape.second()),
                        part(shape.second(), shape.weights()), "what was learned");
}

std::string curve_text(const std::vector<StepRecord>& records) {
    std::string text = "step,loss,rate,iterations\n";
    for (const StepRecord& one : records)
        fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", one.step, one.loss, one.rate, one.iterations);
    return text;
}

Picture preview(const Window& target, const LearningShape& shape, const std::vector<float>& samples) {
    const std::size_t shown = samples.empty() ? 0 : std::min(shape.batch, most_samples), side = shape.side;
    Picture picture(side + shown * (side + gap), side);
    paint(picture, 0, side, [&](std::size_t colour, std::size_t pixel) {
        return target.inside[pixel] ? target.values[colour][pixel] : 1.0;
    });
    for (std::size_t n = 0; n < shown; ++n) {
        paint(picture, (n + 1) * (side + gap), side, [&](std::size_t colour, std::size_t pixel) {
            const float value = samples[n * shape.sample() + colour * shape.cells() + pixel];
            return static_cast<double>(value) + 0.5;
        });
    }
    return enlarged(picture, std::max<std::size_t>(1, least_side / side));
}

double recent_loss(const std::vector<StepRecord>& records, std::size_t count) {
    double sum = 0;
    std::size_t taken = 0;
    for (auto one = records.rbegin(); one != records.rend() && taken < count; ++one) {
        if (!std::isfinite(one->loss)) continue;
        sum += static_cast<double>(one->loss);
        ++taken;
    }
    return taken == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(taken);
}

}  // namespace pelage::learn
