// How a texture is learned: the published course's numbers, each of them an option of the command.
#pragma once

#include "core/learning.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelage::learn {

struct Settings {
    LearningShape shape{64, 4, 32, 128, 8};
    std::uint64_t steps = 2000;
    std::size_t pool = 1024;
    std::uint64_t seed_every = 32;                  // steps from one fresh seed state in the batch to the next
    std::size_t fewest = 32, most = 96;             // iterations of a step
    double rate = 1e-3;                             // of the optimiser
    double drop = 0.2;                              // by which the rate is multiplied ...
    std::vector<std::uint64_t> drops{1000, 10000};  // ... after these steps
    double overflow = 1.0;                          // weight of what chemicals have beyond -1 and 1
    std::optional<double> scale;  // pixels of the picture a cell; none: its shorter side becomes the torus's
    bool wrap = false;            // opposite edges of the picture fit together
    std::int64_t seed = 1;
    std::size_t memory = std::size_t{1} << 30;  // bytes for the states of one step
};

// What a number of a training may be, by the name of the option that sets it.
struct RealLimit {
    const char* option;
    double least, most;

    bool allows(double value) const { return value >= least && value <= most; }  // no NaN is
};

// Beside those of the shape (core/learning.hpp). Messages, help and pages have their numbers from here.
namespace limits {
inline constexpr WholeLimit steps{"--steps", 1, 100'000'000};
inline constexpr WholeLimit pool{"--pool", 1, 1'000'000};
inline constexpr WholeLimit seed_every{"--seed-every", 1, 100'000'000};
inline constexpr WholeLimit iterations{"--iterations", 1, 10'000};
inline constexpr WholeLimit drop_at{"--drop-at", 1, 100'000'000};
inline constexpr WholeLimit memory{"--memory", 1, 1 << 20};  // MiB
inline constexpr RealLimit scale{"--scale", 0.1, 1000};
inline constexpr RealLimit rate{"--rate", 1e-9, 1e30};  // below, weights stay what they are in single precision
inline constexpr RealLimit drop{"--drop", 1e-6, 1000};
inline constexpr RealLimit overflow{"--overflow", 0, 1e6};
}  // namespace limits

std::string allowed(const RealLimit&);  // "a number from 0.1 to 1000"

// Throws Error naming the option that cannot be.
void check(const Settings&);

// All that decides what is learned, but for the picture and the number of steps: "--size 64 --batch 4 ...".
std::string identity(const Settings&);

// The rate of step `step`, counted from 1, as planned.
double planned_rate(const Settings&, std::uint64_t step);

// Bytes that a training takes at most, the pool included.
double bytes_needed(const Settings&);

}  // namespace pelage::learn
