// See learner.hpp.
#include "reference/learn/learner.hpp"

#include "core/subnormal.hpp"
#include "reference/learn/adam.hpp"
#include "reference/learn/iteration.hpp"
#include "reference/learn/loss.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace pelage {

namespace {

template <class T>
class ReferenceLearner final : public LearnerOf<T> {
public:
    explicit ReferenceLearner(LearningTask task) : task_(std::move(task)), shape_(task_.shape) {
        check_learning(shape_);
        for (auto* numbers : {&learned_.weights, &learned_.mean, &learned_.square})
            numbers->assign(shape_.weights(), T(0));
    }

    LearningLoss<T> step(std::vector<T>& states, const LearningOrder& order) override {
        const SubnormalsAreZero scope(std::is_same_v<T, float>);
        const double bytes = static_cast<double>(shape_.states() * sizeof(T));
        keeping_ = keeping(order.iterations, bytes, static_cast<double>(task_.memory));
        kept_.resize(keeping_.states());
        kept_[0] = std::move(states);
        for (std::size_t n = 0; n < order.iterations; ++n) iterate_from(n, order.iterations);
        states = last_;
        std::vector<T> along(shape_.states());
        const LearningLoss<T> loss = judge(order.set, along);
        go_back(order.iterations, along);
        if (order.rate != 0) reference::adam(shape_, slopes_, order.rate, order.count, learned_);
        return loss;
    }

    Learned<T> read() const override { return learned_; }
    void write(const Learned<T>& learned) override { learned_ = learned; }
    std::vector<T> slopes() const override { return slopes_; }
    std::string name() const override { return "reference"; }

private:
    // Where the state before iteration n lies.
    std::vector<T>& state(std::size_t n, std::size_t iterations) {
        if (n == iterations) return last_;
        const std::size_t beside = n % keeping_.stride;
        return kept_[beside == 0 ? n / keeping_.stride : keeping_.kept + beside - 1];
    }

    void iterate_from(std::size_t n, std::size_t iterations) {
        const std::vector<T>& from = state(n, iterations);
        std::vector<T>& to = state(n + 1, iterations);
        to.resize(shape_.states());
        for (std::size_t sample = 0; sample < shape_.batch; ++sample)
            reference::iterate(shape_, learned_.weights, from.data() + sample * shape_.sample(),
                               to.data() + sample * shape_.sample());
    }

    LearningLoss<T> judge(std::size_t set, std::vector<T>& along) {
        LearningLoss<T> loss;
        for (std::size_t sample = 0; sample < shape_.batch; ++sample) {
            const auto one = reference::sample_loss(task_, set, last_.data() + sample * shape_.sample(),
                                                    along.data() + sample * shape_.sample());
            loss.samples.push_back(one.value);
            loss.rotations.push_back(one.rotation);
            loss.total = loss.total + one.value;
        }
        loss.total = loss.total * static_cast<T>(1.0 / static_cast<double>(shape_.batch));
        return loss;
    }

    // States between two that were kept are computed once more; those of the last stretch are still there.
    void go_back(std::size_t iterations, std::vector<T>& along) {
        reference::WeightSums<T> sums(shape_);
        for (std::size_t stretch = keeping_.kept; stretch-- > 0;) {
            const std::size_t begin = stretch * keeping_.stride;
            const std::size_t end = std::min(begin + keeping_.stride, iterations);
            for (std::size_t n = begin; n + 1 < end && end < iterations; ++n) iterate_from(n, iterations);
            for (std::size_t n = end; n-- > begin;) {
                for (std::size_t sample = 0; sample < shape_.batch; ++sample)
                    reference::reverse_iteration(shape_, learned_.weights,
                                                 state(n, iterations).data() + sample * shape_.sample(),
                                                 along.data() + sample * shape_.sample(), sample, sums);
            }
        }
        slopes_ = sums.totals();
    }

    LearningTask task_;
    LearningShape shape_;
    Learned<T> learned_;
    Keeping keeping_;
    std::vector<std::vector<T>> kept_;
    std::vector<T> last_, slopes_;
};

}  // namespace

template <class T>
std::unique_ptr<LearnerOf<T>> reference_learner(LearningTask task) {
    return std::make_unique<ReferenceLearner<T>>(std::move(task));
}

template std::unique_ptr<LearnerOf<float>> reference_learner(LearningTask);
template std::unique_ptr<LearnerOf<double>> reference_learner(LearningTask);

}  // namespace pelage
