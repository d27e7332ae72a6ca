// See learner.hpp.
#include "opencl/learn/learner.hpp"

#include "opencl/device/cl_error.hpp"
#include "opencl/device/session.hpp"
#include "opencl/learn/iteration.hpp"
#include "opencl/learn/loss.hpp"
#include "opencl/learn/settings.hpp"
#include "opencl/learn/update.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

namespace {

class OpenclLearner final : public Learner {
public:
    OpenclLearner(const LearningTask& task, const OpenclOptions& options)
        : shape_(task.shape), memory_(task.memory), session_(select_device(options.device), options) {
        check_learning(shape_);
        with_device(session_.info().name, [&] {
            iteration_.emplace(session_, shape_);
            judge_.emplace(session_, task);
            update_.emplace(session_, shape_);
            last_ = state_buffer();
            after_ = state_buffer();
            before_ = state_buffer();
        });
    }

    LearningLoss<float> step(std::vector<float>& states, const LearningOrder& order) override {
        return with_device(session_.info().name, [&] {
            make_room(order.iterations);
            session_.queue().enqueueWriteBuffer(kept_[0], CL_TRUE, 0, bytes(), states.data());
            for (std::size_t n = 0; n < order.iterations; ++n) iterate_from(n, order.iterations);
            const LearningLoss<float> loss = judge_->judge(last_, order.set, after_);
            session_.queue().enqueueReadBuffer(last_, CL_TRUE, 0, bytes(), states.data());
            go_back(order.iterations);
            if (order.rate != 0) update_->adam(order.rate, order.count);
            return loss;
        });
    }

    Learned<float> read() const override {
        return with_device(session_.info().name, [&] { return update_->read(); });
    }
    void write(const Learned<float>& learned) override {
        with_device(session_.info().name, [&] { update_->write(learned); });
    }
    std::vector<float> slopes() const override {
        return with_device(session_.info().name, [&] { return update_->slopes(); });
    }
    std::string name() const override { return "opencl: " + session_.info().name; }

private:
    std::size_t bytes() const { return shape_.states() * sizeof(float); }
    cl::Buffer state_buffer() const { return float_buffer(session_, shape_.states(), "states"); }

    void make_room(std::size_t iterations) {
        keeping_ = keeping(iterations, static_cast<double>(bytes()), static_cast<double>(memory_));
        while (kept_.size() < keeping_.states()) kept_.push_back(state_buffer());
    }

    // Where the state before iteration n lies.
    const cl::Buffer& state(std::size_t n, std::size_t iterations) const {
        if (n == iterations) return last_;
        const std::size_t beside = n % keeping_.stride;
        return kept_[beside == 0 ? n / keeping_.stride : keeping_.kept + beside - 1];
    }

    void iterate_from(std::size_t n, std::size_t iterations) {
        iteration_->iterate(update_->weights(), state(n, iterations), state(n + 1, iterations));
    }

    // States between two that were kept are computed once more; those of the last stretch are still there.
    void go_back(std::size_t iterations) {
        iteration_->begin_sums();
        for (std::size_t stretch = keeping_.kept; stretch-- > 0;) {
            const std::size_t begin = stretch * keeping_.stride;
            const std::size_t end = std::min(begin + keeping_.stride, iterations);
            for (std::size_t n = begin; n + 1 < end && end < iterations; ++n) iterate_from(n, iterations);
            for (std::size_t n = end; n-- > begin;) {
                iteration_->reverse(update_->weights(), state(n, iterations), after_, before_);
                std::swap(after_, before_);
            }
        }
        update_->total(iteration_->sums());
    }

    LearningShape shape_;
    std::size_t memory_;
    Session session_;
    std::optional<LearnedIteration> iteration_;
    std::optional<LearningJudge> judge_;
    std::optional<WeightUpdate> update_;
    Keeping keeping_;
    std::vector<cl::Buffer> kept_;
    cl::Buffer last_, after_, before_;
};

}  // namespace

std::unique_ptr<Learner> opencl_learner(const LearningTask& task, const OpenclOptions& options) {
    return std::make_unique<OpenclLearner>(task, options);
}

}  // namespace pelage
