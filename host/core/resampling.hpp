// Growth of a lattice by interpolation: what each element of the larger lattice takes from the smaller one.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage {

// One axis. Places are pixels of a picture that is stretched: new place i lies at (i + 1/2) * old / new - 1/2.
struct Sampling {
    std::size_t places = 0;             // new ones
    std::size_t others = 0;             // elements that weigh in beside the base: 0 nearest, 1 bilinear, 3 bicubic
    std::vector<std::int32_t> nearest;  // [place], what all but concentrations is taken from
    std::vector<std::int32_t> sources;  // [place][1 + others], the base first
    std::vector<double> weights;        // [place][others]
};

// A concentration is sampled along its row first: base + sum of weight * (other - base), in order, each term added by
// a fused multiply-add. The same sum over the rows' samples follows. Equal elements so stay what they are to the bit.
struct Resampling {
    Sampling across;  // columns
    Sampling up;      // rows
};

// Beyond the edge a torus goes on at the other side; any other lattice repeats its edge element. Bicubic is the
// interpolating cubic convolution of Keys (1981), a = -1/2.
Sampling sampling(Interpolation, bool wrap, std::size_t old_places, std::size_t new_places);

}  // namespace pelage
