// See update.hpp.
#include "opencl/learn/update.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/learn/settings.hpp"
#include "opencl/rules/functions.hpp"

#include <array>
#include <cmath>

namespace pelage {

namespace {

constexpr std::size_t numbers_of_adam = 8;

cl_int4 ends_of(const LearningShape& shape) {
    return {{static_cast<cl_int>(shape.bias()), static_cast<cl_int>(shape.second()),
             static_cast<cl_int>(shape.weights()), 0}};
}

// One program for all shapes.
Source update_source() {
    Source source;
    source.text("#define PELAGE_WIDTH 1\n").file("common/prelude.cl");
    for (const std::string& file : function_files({}, {"quotient"})) source.file(file);
    return source.file("learn/sums.cl").file("learn/update.cl");
}

}  // namespace

WeightUpdate::WeightUpdate(const Session& session, const LearningShape& shape)
    : session_(session),
      shape_(shape),
      factors_(float_buffer(session, 3, "lengths of slopes")),
      numbers_(float_buffer(session, numbers_of_adam, "numbers of the optimiser")) {
    const std::vector<float> zeros(shape.weights());
    for (cl::Buffer* one : {&weights_, &means_, &squares_, &slopes_}) *one = filled_buffer(session, zeros, "weights");
    const cl::Program program = session.build(update_source().str());
    total_ = cl::Kernel(program, "pelage_learn_total");
    lengths_ = cl::Kernel(program, "pelage_learn_lengths");
    adam_ = cl::Kernel(program, "pelage_learn_adam");
    for (cl::Kernel* one : {&lengths_, &adam_}) one->setArg(one == &lengths_ ? 1 : 2, ends_of(shape));
}

Learned<float> WeightUpdate::read() const {
    Learned<float> learned;
    const auto take = [&](const cl::Buffer& from, std::vector<float>& to) {
        to.resize(shape_.weights());
        session_.queue().enqueueReadBuffer(from, CL_TRUE, 0, to.size() * sizeof(float), to.data());
    };
    take(weights_, learned.weights);
    take(means_, learned.mean);
    take(squares_, learned.square);
    return learned;
}

void WeightUpdate::write(const Learned<float>& learned) {
    const auto put = [&](const std::vector<float>& from, const cl::Buffer& to) {
        session_.queue().enqueueWriteBuffer(to, CL_TRUE, 0, shape_.weights() * sizeof(float), from.data());
    };
    put(learned.weights, weights_);
    put(learned.mean, means_);
    put(learned.square, squares_);
}

std::vector<float> WeightUpdate::slopes() const {
    std::vector<float> slopes(shape_.weights());
    session_.queue().enqueueReadBuffer(slopes_, CL_TRUE, 0, slopes.size() * sizeof(float), slopes.data());
    return slopes;
}

void WeightUpdate::total(const cl::Buffer& sums) {
    Arguments(session_, total_).add(sums, shape_.batch * cell_runs, shape_.weights(), slopes_);
    launch(session_, total_, shape_.weights(), 64);
}

void WeightUpdate::adam(double rate, std::uint64_t count) {
    const auto steps = static_cast<double>(count);
    const std::array<double, numbers_of_adam> numbers{mean_decay,
                                                      1 - mean_decay,
                                                      square_decay,
                                                      1 - square_decay,
                                                      rate / (1 - std::pow(mean_decay, steps)),
                                                      1 / (1 - std::pow(square_decay, steps)),
                                                      smallest_square,
                                                      smallest_divisor};
    std::array<float, numbers_of_adam> singles{};
    for (std::size_t n = 0; n < numbers.size(); ++n) singles[n] = static_cast<float>(numbers[n]);
    session_.queue().enqueueWriteBuffer(numbers_, CL_TRUE, 0, sizeof singles, singles.data());
    Arguments(session_, lengths_).add(slopes_);
    Arguments(session_, lengths_, 2).add(Scalar{smallest_square}, Scalar{smallest_divisor}, factors_);
    launch(session_, lengths_, 3 * sum_lanes, sum_lanes);
    Arguments(session_, adam_).add(slopes_, factors_);
    Arguments(session_, adam_, 3).add(numbers_, weights_, means_, squares_);
    launch(session_, adam_, shape_.weights(), 64);
}

}  // namespace pelage
