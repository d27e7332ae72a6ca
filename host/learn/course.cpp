// See course.hpp.
#include "learn/course.hpp"

#include "learn/draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pelage::learn {

namespace {

constexpr std::uint64_t steps_between_sound = 32;  // from one set of weights that is kept to the next
constexpr double least_slowed = 0x1p-16;

Learned<float> first_weights(const Settings& settings) {
    const LearningShape& shape = settings.shape;
    Learned<float> learned;
    for (auto* numbers : {&learned.weights, &learned.mean, &learned.square}) numbers->assign(shape.weights(), 0.0f);
    // X. Glorot and Y. Bengio, "Understanding the difficulty of training deep feedforward neural networks" (2010).
    const double width = std::sqrt(6.0 / static_cast<double>(shape.chemicals + shape.hidden));
    for (std::size_t n = 0; n < shape.bias(); ++n)
        learned.weights[n] = static_cast<float>(width * around_zero(settings.seed, Draw::weights, n));
    return learned;
}

bool all_finite(const std::vector<float>& numbers) {
    return std::ranges::all_of(numbers, [](float number) { return std::isfinite(number); });
}

}  // namespace

Course::Course(const Settings& settings, std::unique_ptr<Learner> learner)
    : settings_(settings), learner_(std::move(learner)), pool_(settings) {
    const Learned<float> first = first_weights(settings_);
    learner_->write(first);
    state_.sound = first;
    std::vector<float> seeds;
    for (std::size_t place = 0; place < settings_.shape.batch; ++place) {
        const std::vector<float> one = pool_.at(place);
        seeds.insert(seeds.end(), one.begin(), one.end());
    }
    state_.seed_loss = learner_->step(seeds, {1, 0, 0.0, 1}).total;
}

CourseState Course::state() const {
    CourseState state = state_;
    state.learned = learner_->read();
    return state;
}

void Course::restore(CourseState state, PoolStates pool) {
    learner_->write(state.learned);
    pool_.restore(std::move(pool));
    state_ = std::move(state);
}

std::vector<std::size_t> Course::gather(std::uint64_t step) {
    const std::vector<std::size_t> places = pool_.drawn_places(step);
    samples_.clear();
    for (std::size_t n = 0; n < places.size(); ++n) {
        const bool seeded = n == 0 && step % settings_.seed_every == 0;
        const std::vector<float> one = seeded ? pool_.fresh(step) : pool_.at(places[n]);
        samples_.insert(samples_.end(), one.begin(), one.end());
    }
    return places;
}

bool Course::sound(float loss) const { return std::isfinite(loss) && all_finite(learner_->read().weights); }

const StepRecord& Course::advance() {
    const std::uint64_t step = state_.steps + 1;
    const std::vector<std::size_t> places = gather(step);
    LearningOrder order;
    const std::size_t choices = settings_.most - settings_.fewest + 1;
    order.iterations = settings_.fewest + one_of(drawn(settings_.seed, Draw::iterations, 0, step)[0], choices);
    order.set = static_cast<std::size_t>(step % direction_sets);
    order.rate = planned_rate(settings_, step) * state_.slowed;
    order.count = state_.count + 1;
    StepRecord record{step, learner_->step(samples_, order).total, order.rate, order.iterations};
    state_.steps = step;
    if (sound(record.loss)) {
        ++state_.count;
        const std::size_t sample = settings_.shape.sample();
        for (std::size_t n = 0; n < places.size(); ++n) pool_.put(places[n], samples_.data() + n * sample);
        if (step % steps_between_sound == 0) {
            state_.sound = learner_->read();
            state_.sound_count = state_.count;
        }
    } else {
        record.loss = std::numeric_limits<float>::quiet_NaN();
        go_back(places);
    }
    state_.records.push_back(record);
    check_rate();
    return state_.records.back();
}

void Course::go_back(const std::vector<std::size_t>& places) {
    learner_->write(state_.sound);
    state_.count = state_.sound_count;
    for (const std::size_t place : places) pool_.forget(place);
    state_.slowed /= 2;
}

void Course::check_rate() const {
    if (std::isfinite(state_.records.back().loss) || state_.slowed >= least_slowed) return;
    throw RanAway(fmt::format(
        "numbers run away at step {}, even at a learning rate of {:.2g}; a smaller --rate or --iterations may help",
        state_.steps, state_.records.back().rate));
}

}  // namespace pelage::learn
