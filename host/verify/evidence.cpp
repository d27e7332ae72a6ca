// See evidence.hpp.
#include "verify/evidence.hpp"

#include "io/brush.hpp"
#include "io/colour.hpp"
#include "io/exr.hpp"
#include "io/picture.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace pelage::verify {

namespace {

Picture drawn(const std::vector<double>& values, const Evidence& evidence) {
    Output output;
    output.colormap.name = "viridis";
    return render(values, evidence.columns, evidence.rows, output);
}

std::uint8_t faded(double strength) { return static_cast<std::uint8_t>(std::lround(128 * (1 - strength))); }

// Half of the colour for any difference at all: one ulp must show beside a large one.
Rgb shade(double expected, double found, double largest) {
    if (std::bit_cast<std::uint64_t>(expected) == std::bit_cast<std::uint64_t>(found)) return grey;
    const double difference = found - expected;
    if (difference == 0 || !std::isfinite(difference)) return magenta;
    const double strength = 0.5 + 0.5 * std::abs(difference) / largest;
    const std::uint8_t low = faded(strength);
    const auto high = static_cast<std::uint8_t>(255 - low);
    return difference > 0 ? Rgb{high, low, low} : Rgb{low, low, high};
}

Picture difference_picture(const Evidence& evidence) {
    double largest = 0.0;
    for (std::size_t i = 0; i < evidence.expected.size(); ++i) {
        const double difference = std::abs(evidence.found[i] - evidence.expected[i]);
        if (std::isfinite(difference)) largest = std::max(largest, difference);
    }
    Picture picture(evidence.columns, evidence.rows);
    for (std::size_t row = 0; row < evidence.rows; ++row) {
        for (std::size_t column = 0; column < evidence.columns; ++column) {
            const std::size_t cell = row * evidence.columns + column;
            picture.at(column, evidence.rows - 1 - row) =
                shade(evidence.expected[cell], evidence.found[cell], largest > 0 ? largest : 1);
        }
    }
    return picture;
}

}  // namespace

std::vector<std::filesystem::path> keep_evidence(const Evidence& evidence, const std::string& name,
                                                 const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::string stem = name;
    std::ranges::replace(stem, '/', '-');
    std::vector<double> difference(evidence.expected.size());
    std::ranges::transform(evidence.found, evidence.expected, difference.begin(), std::minus<>());
    std::vector<std::filesystem::path> files;
    const std::size_t factor = enlargement(evidence.columns, evidence.rows);
    const auto keep = [&](const char* side, const std::vector<double>& values, const Picture& picture) {
        const std::filesystem::path base = folder / (stem + "." + side);
        write_exr(base.string() + ".exr", evidence.columns, evidence.rows, {{"conc", values}},
                  {{"pelage:what", evidence.what}});
        write_png(base.string() + ".png", enlarged(picture, factor));
        files.emplace_back(base.string() + ".exr");
        files.emplace_back(base.string() + ".png");
    };
    keep("reference", evidence.expected, drawn(evidence.expected, evidence));
    keep("device", evidence.found, drawn(evidence.found, evidence));
    keep("difference", difference, difference_picture(evidence));
    return files;
}

}  // namespace pelage::verify
