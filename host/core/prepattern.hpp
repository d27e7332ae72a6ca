// From an experiment's `create`, `use` and `set` statements to the tissue's first state.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <array>
#include <cstdint>

namespace pelage {

// The generator the published experiments were drawn with: glibc's TYPE_3 additive feedback rand().
class PublishedRandom {
public:
    explicit PublishedRandom(std::uint32_t seed = 1);
    std::uint32_t next();                         // 0 .. 2^31 - 1
    float range(float low, float high);           // low + (high - low) * next / (2^31 - 1), in float
    float deviate(float value, float deviation);  // no draw where deviation is 0

private:
    std::array<std::uint32_t, 31> words_{};
    std::size_t front_ = 3;
    std::size_t back_ = 0;
};

// Draws position jitter (y before x), then polarity, then conc and diff of each chemical, cell by cell, as the
// published program does. Throws Error when a `set` names a cell that does not exist, when there are no cells, or
// when a field's shape is not the lattice's.
Snapshot initial_state(const Experiment&);

std::size_t count_cells(const Experiment&);  // without creating them

}  // namespace pelage
