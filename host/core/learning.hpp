// What it is to learn a texture: numbers of a network are changed, step by step, until what grows on a torus looks like
// a picture. Both backends carry out such steps behind one interface. The course is that of A. Mordvintsev, E. Randazzo
// and E. Niklasson, "Differentiable Programming of Chemical Reaction-Diffusion" (2021).
#pragma once

#include "core/neural.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage {

// The loss compares patches of 7 x 7 pixels of a picture and of its halves and quarters, each seen along many
// directions.
inline constexpr std::size_t picture_colours = 3;
inline constexpr std::size_t pyramid_levels = 3;
inline constexpr std::size_t patch_side = 7;
inline constexpr std::size_t patch_numbers = picture_colours * patch_side * patch_side;
inline constexpr std::size_t patch_directions = 32;  // of a level and a step
inline constexpr std::size_t direction_sets = 8;     // steps take them by turns

// Long sums have an order of their own, the same on every device: so many partial sums stand side by side, the n-th
// takes every element whose place divided by their number leaves n; in the end the upper half is added to the lower one
// until one is left.
inline constexpr std::size_t sum_lanes = 16;
// The cells of a sample come in so many runs (the last ones may be shorter or empty), each summed by itself.
inline constexpr std::size_t cell_runs = 8;

struct LearningShape {
    std::size_t side = 64;  // of the square torus, a multiple of sum_lanes and at least 32
    std::size_t batch = 4;  // samples of a step
    std::size_t chemicals = 32;
    std::size_t hidden = 128;   // a multiple of hidden_block
    std::size_t rotations = 1;  // of the target, the best of which counts for each sample

    bool operator==(const LearningShape&) const = default;

    std::size_t cells() const { return side * side; }
    std::size_t sample() const { return chemicals * cells(); }  // numbers of a sample's state
    std::size_t states() const { return batch * sample(); }

    // Weights stand in one array: W0 [chemical][hidden], b0 [hidden], W1 [hidden][chemical].
    std::size_t bias() const { return chemicals * hidden; }
    std::size_t second() const { return bias() + hidden; }
    std::size_t weights() const { return second() + hidden * chemicals; }

    std::size_t level_side(std::size_t level) const { return side >> level; }
    std::size_t level_cells(std::size_t level) const { return level_side(level) * level_side(level); }
    std::size_t level_begin(std::size_t level) const {  // cells of the levels before
        return level == 0 ? 0 : level_begin(level - 1) + level_cells(level - 1);
    }
    std::size_t run_cells() const {
        const std::size_t rounds = cells() / sum_lanes;
        return (rounds + cell_runs - 1) / cell_runs * sum_lanes;
    }
};

struct LearningTask {
    LearningShape shape;
    // [set][level][number of a patch][direction]; a number is (colour * patch_side + row) * patch_side + column.
    std::vector<float> directions;
    // What the target has along each direction, in ascending order: [set][rotation][level][direction][rank].
    std::vector<float> ranked;
    double overflow = 1.0;          // weight of what chemicals have beyond -1 and 1
    std::size_t memory = 1u << 30;  // bytes that kept states may take
};

// A run of iterations, and then a step of the optimiser.
struct LearningOrder {
    std::size_t iterations = 32;
    std::size_t set = 0;      // of directions
    double rate = 1e-3;       // of learning
    std::uint64_t count = 1;  // which step of the optimiser it is, from 1
};

template <class T>
struct LearningLoss {
    T total = 0;  // the mean of those of the samples
    std::vector<T> samples;
    std::vector<std::size_t> rotations;  // of the target that fits each sample best
};

// D. Kingma and J. Ba, "Adam: A method for stochastic optimization" (2015), with its usual constants. The slopes of
// each of the three arrays of weights are brought to length 1 before (Niklasson et al., "Self-organising textures",
// 2021).
inline constexpr double mean_decay = 0.9, square_decay = 0.999, smallest_divisor = 1e-8;
// Squares below it count as 0: their roots are out of the range of our root.
inline constexpr double smallest_square = 0x1p-120;

template <class T>
struct Learned {
    std::vector<T> weights, mean, square;  // the last two are the optimiser's

    bool operator==(const Learned&) const = default;
};

template <class T>
class LearnerOf {
public:
    virtual ~LearnerOf() = default;
    LearnerOf() = default;
    LearnerOf(const LearnerOf&) = delete;
    LearnerOf& operator=(const LearnerOf&) = delete;

    // states: [sample][chemical][cell], replaced by what they have become. With rate 0 the weights stay.
    virtual LearningLoss<T> step(std::vector<T>& states, const LearningOrder&) = 0;
    virtual Learned<T> read() const = 0;
    virtual void write(const Learned<T>&) = 0;
    virtual std::vector<T> slopes() const = 0;  // of the last step's loss, weight by weight, as they came
    virtual std::string name() const = 0;       // "reference", "opencl: NAME OF DEVICE"
};

using Learner = LearnerOf<float>;

// How states are kept for the way back: every `stride`-th, and those between while they are needed.
struct Keeping {
    std::size_t stride = 1;
    std::size_t kept = 0;     // states that are kept, the first among them
    std::size_t between = 0;  // room for states between two that are kept

    std::size_t states() const { return kept + between; }
};

// The smallest stride with which the states fit into `memory` bytes, each having `bytes`; the one that takes least
// where none does.
Keeping keeping(std::size_t iterations, double bytes, double memory);

// What a whole number of a training may be, by the name of the option that sets it.
struct WholeLimit {
    const char* option;
    std::uint64_t least, most, multiple = 1;

    bool allows(std::uint64_t value) const { return value >= least && value <= most && value % multiple == 0; }
};

namespace learning_limits {
inline constexpr WholeLimit size{"--size", 2 * sum_lanes, 512, sum_lanes};
inline constexpr WholeLimit batch{"--batch", 1, 64};
inline constexpr WholeLimit chemicals{"--chemicals", chemical_groups, largest_network_chemicals, chemical_groups};
inline constexpr WholeLimit hidden{"--hidden", hidden_block, largest_hidden, hidden_block};
inline constexpr WholeLimit rotations{"--rotations", 1, 64};
}  // namespace learning_limits

// "a multiple of 16 from 32 to 512", "a whole number from 1 to 64"
std::string allowed(const WholeLimit&);

// Throws Error naming the option that is out of its range.
void check_limit(const WholeLimit&, std::uint64_t value);
void check_learning(const LearningShape&);

}  // namespace pelage
