// The pool of states from which each step takes its samples and to which it gives them back.
#pragma once

#include "core/learning.hpp"
#include "learn/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace pelage::learn {

// About one spot in 200 cells, with a sigma of 3 cells and 0.145 high, alike in the three chemicals that are colours;
// the others are 0. [chemical][cell]
std::vector<float> seed_state(const LearningShape&, std::int64_t seed, std::size_t which);

using PoolStates = std::map<std::size_t, std::vector<float>>;  // by place

// Places that nobody has given anything back to hold seed states and take no memory.
class Pool {
public:
    explicit Pool(const Settings& settings) : shape_(settings.shape), size_(settings.pool), seed_(settings.seed) {}

    // Different places for one step, drawn by its number.
    std::vector<std::size_t> drawn_places(std::uint64_t step) const;
    std::vector<float> at(std::size_t place) const;
    // What is not finite, or far beyond what a texture needs, is thrown away: the place becomes a seed state again.
    void put(std::size_t place, const float* state);
    void forget(std::size_t place) { kept_.erase(place); }
    std::vector<float> fresh(std::uint64_t step) const;  // a seed state that no place has

    const PoolStates& kept() const { return kept_; }
    void restore(PoolStates kept) { kept_ = std::move(kept); }

private:
    LearningShape shape_;
    std::size_t size_;
    std::int64_t seed_;
    PoolStates kept_;
};

}  // namespace pelage::learn
