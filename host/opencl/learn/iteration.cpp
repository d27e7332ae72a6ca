// See iteration.hpp.
#include "opencl/learn/iteration.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/learn/settings.hpp"

namespace pelage {

namespace {

constexpr std::size_t lane_share = 4;  // PELAGE_SHARE of learn/reverse_lanes.cl

}  // namespace

LearnedIteration::LearnedIteration(const Session& session, const LearningShape& shape)
    : session_(session),
      shape_(shape),
      width_(learning_width(session)),
      shared_(shared_learning(session)),
      sums_(float_buffer(session, shape.batch * cell_runs * shape.weights() * sum_lanes, "slopes of weights")) {
    const std::size_t hidden = shape.batch * shape.cells() * shape.hidden;
    const std::size_t tiles = shape.batch * cell_runs * 2 * shape.hidden * learning_tile;
    scratch_ = float_buffer(session, shared_ ? hidden : tiles, "hidden values");
    if (shared_) slopes_ = float_buffer(session, hidden, "slopes of hidden values");
    Source source = learning_source(session, shape, width_).file("learn/iteration.cl");
    if (shared_) source.file("learn/reverse_lanes.cl");
    const cl::Program program = session.build(source.str());
    iterate_ = cl::Kernel(program, "pelage_learn_iterate");
    reverse_ = cl::Kernel(program, shared_ ? "pelage_learn_reverse_cells" : "pelage_learn_reverse");
    if (shared_) add_ = cl::Kernel(program, "pelage_learn_add_lanes");
}

void LearnedIteration::iterate(const cl::Buffer& weights, const cl::Buffer& from, const cl::Buffer& to) {
    const std::size_t vectors = shared_ ? 1 : shape_.side / width_;  // a row
    Arguments(session_, iterate_).add(weights, from, to, vectors);
    launch(session_, iterate_, shape_.batch * shape_.cells() / width_ / vectors, learning_group(session_));
}

void LearnedIteration::begin_sums() {
    const std::size_t numbers = shape_.batch * cell_runs * shape_.weights() * sum_lanes;
    session_.queue().enqueueFillBuffer(sums_, cl_float{0}, 0, numbers * sizeof(cl_float));
}

void LearnedIteration::reverse(const cl::Buffer& weights, const cl::Buffer& state, const cl::Buffer& after,
                               const cl::Buffer& before) {
    if (shared_) return reverse_lanes(weights, state, after, before);
    Arguments(session_, reverse_).add(weights, state, after, before, scratch_, sums_);
    launch(session_, reverse_, shape_.batch * cell_runs);
}

void LearnedIteration::reverse_lanes(const cl::Buffer& weights, const cl::Buffer& state, const cl::Buffer& after,
                                     const cl::Buffer& before) {
    Arguments(session_, reverse_).add(weights, state, after, before, scratch_, slopes_);
    launch(session_, reverse_, shape_.batch * shape_.cells() / width_, learning_group(session_));
    Arguments(session_, add_).add(state, after, scratch_, slopes_, sums_);
    const std::size_t shares = shape_.chemicals / lane_share * (shape_.hidden / lane_share);
    launch(session_, add_, shape_.batch * cell_runs * shares * sum_lanes, learning_group(session_));
}

}  // namespace pelage
