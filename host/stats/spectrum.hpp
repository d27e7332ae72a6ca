// The waves that a pattern is made of.
#pragma once

#include "stats/grid.hpp"

#include <vector>

namespace pelage::stats {

struct Waves {
    double wavelength = 0.0;  // in cells, where the radial spectrum has most power; 0: there is no wave
    double anisotropy = 0.0;  // of the waves of about that length: 0 all directions alike, 1 a single one
    double direction =
        0.0;  // along which those waves repeat, in degrees from 0 (along rows) to below 180, counter-clockwise
    std::vector<double>
        radial;  // power by wave number: entry i is of i waves along the longer side, to the shortest waves
};

// By Fourier transform of what differs from the mean. A grid that does not wrap is tapered towards its edges first
// (Hann's window), so that its edges are no waves. Wavelengths between neighbouring entries are found to a tenth of
// their distance; those longer than the grid are not.
Waves waves_of(const Grid&);

}  // namespace pelage::stats
