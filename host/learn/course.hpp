// A training's course: which states a step takes, how many iterations they make, what becomes of them, and what happens
// where numbers run away.
#pragma once

#include "core/error.hpp"
#include "core/learning.hpp"
#include "learn/pool.hpp"
#include "learn/settings.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace pelage::learn {

struct StepRecord {  // a line of the loss curve
    std::uint64_t step = 0;
    float loss = 0;  // NaN: numbers ran away, and the step was taken back
    double rate = 0;
    std::uint64_t iterations = 0;
};

// All that decides how a training goes on, but for the pool.
struct CourseState {
    std::uint64_t steps = 0;  // made so far
    std::uint64_t count = 0;  // of the optimiser
    double slowed = 1.0;      // the rate's factor, halved whenever numbers ran away
    Learned<float> learned;
    Learned<float> sound;  // to which it goes back then
    std::uint64_t sound_count = 0;
    float seed_loss = 0;  // of seed states
    std::vector<StepRecord> records;
};

class RanAway : public Error {
public:
    using Error::Error;
};

class Course {
public:
    // Fresh weights: W0 even around 0, the others 0.
    Course(const Settings&, std::unique_ptr<Learner>);

    CourseState state() const;
    const PoolStates& pool() const { return pool_.kept(); }
    void restore(CourseState, PoolStates);

    // One step. Throws RanAway when numbers run away however small the rate; the state is then as after any step.
    const StepRecord& advance();

    std::uint64_t steps() const { return state_.steps; }
    float seed_loss() const { return state_.seed_loss; }
    const std::vector<StepRecord>& records() const { return state_.records; }
    const std::vector<float>& samples() const { return samples_; }  // as the last step left them; empty before it
    Learned<float> learned() const { return learner_->read(); }
    std::string backend() const { return learner_->name(); }

private:
    std::vector<std::size_t> gather(std::uint64_t step);
    bool sound(float loss) const;
    void go_back(const std::vector<std::size_t>& places);
    void check_rate() const;

    Settings settings_;
    std::unique_ptr<Learner> learner_;
    Pool pool_;
    CourseState state_;  // but for the weights, which the learner has
    std::vector<float> samples_;
};

}  // namespace pelage::learn
