// See statistics.hpp.
#include "stats/statistics.hpp"

#include "stats/dimension.hpp"
#include "stats/excess.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pelage::stats {

namespace {

Statistics of_scaled(const Grid& grid, int excess) {
    std::vector<double> values(grid.values.begin(), grid.values.end());
    for (double& value : values) value = std::ldexp(value, -excess);
    Statistics found = statistics_of({values, grid.columns, grid.rows, grid.wrap});
    for (double* one : {&found.mean, &found.deviation, &found.minimum, &found.maximum}) *one = std::ldexp(*one, excess);
    return found;
}

}  // namespace

Statistics statistics_of(const Grid& grid) {
    check(grid);
    if (const int excess = excess_of(grid.values); excess != 0) return of_scaled(grid, excess);
    Statistics found;
    const double count = static_cast<double>(grid.values.size());
    for (const double value : grid.values) found.mean += value / count;
    for (const double value : grid.values) found.deviation += (value - found.mean) * (value - found.mean) / count;
    found.deviation = std::sqrt(found.deviation);
    const auto [low, high] = std::minmax_element(grid.values.begin(), grid.values.end());
    found.minimum = *low;
    found.maximum = *high;
    found.features = features_of(grid);
    found.orientation_order = orientation_order(grid);
    found.waves = waves_of(grid);
    found.dimension = dimension_of(grid);
    return found;
}

std::vector<std::pair<std::string, double>> listed(const Statistics& of) {
    return {{"mean", of.mean},
            {"deviation", of.deviation},
            {"minimum", of.minimum},
            {"maximum", of.maximum},
            {"features", static_cast<double>(of.features.count)},
            {"feature_size", of.features.size},
            {"coverage", of.features.coverage},
            {"wavelength", of.waves.wavelength},
            {"anisotropy", of.waves.anisotropy},
            {"direction", of.waves.direction},
            {"orientation_order", of.orientation_order},
            {"dimension", of.dimension}};
}

bool uniform(const Statistics& of) {
    return of.maximum - of.minimum <= 1e-3 * std::max(std::fabs(of.maximum), std::fabs(of.minimum));
}

}  // namespace pelage::stats
