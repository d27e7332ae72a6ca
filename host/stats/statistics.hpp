// All that is measured of one pattern.
#pragma once

#include "stats/features.hpp"
#include "stats/grid.hpp"
#include "stats/spectrum.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pelage::stats {

struct Statistics {
    double mean = 0.0;
    double deviation = 0.0;  // root of the mean squared distance from the mean
    double minimum = 0.0;
    double maximum = 0.0;
    Features features;
    double orientation_order = 0.0;
    Waves waves;
    double dimension = 0.0;
};

Statistics statistics_of(const Grid&);

// Names and values, in the order of columns in tables.
std::vector<std::pair<std::string, double>> listed(const Statistics&);

// Every value is as good as equal: they differ by no more than a thousandth of the largest.
bool uniform(const Statistics&);

}  // namespace pelage::stats
