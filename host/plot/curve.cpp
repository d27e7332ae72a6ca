// See curve.hpp.
#include "plot/curve.hpp"

#include "core/error.hpp"
#include "plot/canvas.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pelage::bench {

namespace {

constexpr Colour pale{0.70, 0.80, 0.90}, strong{0.00, 0.45, 0.70};

std::vector<Spot> spots_of(const nlohmann::json& curve) {
    const auto x = curve.at("x").get<std::vector<double>>(), y = curve.at("y").get<std::vector<double>>();
    std::vector<Spot> spots;
    for (std::size_t n = 0; n < std::min(x.size(), y.size()); ++n) {
        if (x[n] > 0 && y[n] > 0) spots.push_back({x[n], y[n]});
    }
    return spots;
}

// The mean of each spot and those before it, up to a fifth of their number and 100.
std::vector<Spot> smoothed(const std::vector<Spot>& spots) {
    std::vector<Spot> means;
    for (std::size_t n = 0; n < spots.size(); ++n) {
        const std::size_t count = 1 + std::min<std::size_t>(n / 5, 99);
        double sum = 0;
        for (std::size_t k = 0; k < count; ++k) sum += spots[n - k].y;
        means.push_back({spots[n].x, sum / static_cast<double>(count)});
    }
    return means;
}

}  // namespace

void draw_curve(const nlohmann::json& curve, const std::filesystem::path& file) {
    const std::vector<Spot> spots = spots_of(curve);
    if (spots.empty()) throw Error("no loss of the curve is a number above 0: there is nothing to draw");
    const auto [least, most] = std::ranges::minmax(spots, {}, &Spot::y);
    const double low = std::pow(10.0, std::floor(std::log10(least.y)));
    const double high = std::pow(10.0, std::floor(std::log10(most.y)) + 1);
    const double last = std::pow(10.0, std::floor(std::log10(spots.back().x)) + 1);
    Diagram diagram("Loss of " + curve.at("title").get<std::string>(), {"steps", 1, std::max(last, 10.0)},
                    {"loss", low, high});
    diagram.line(spots, pale);
    diagram.line(smoothed(spots), strong);
    diagram.legend("each step", pale);
    diagram.legend("mean", strong);
    diagram.write(file);
}

}  // namespace pelage::bench
