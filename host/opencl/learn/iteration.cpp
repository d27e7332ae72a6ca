// See iteration.hpp.
#include "opencl/learn/iteration.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/learn/settings.hpp"

namespace pelage {

LearnedIteration::LearnedIteration(const Session& session, const LearningShape& shape)
    : session_(session),
      shape_(shape),
      width_(learning_width(session)),
      scratch_(float_buffer(session, shape.batch * cell_runs * 2 * shape.hidden * learning_tile, "hidden values")),
      sums_(float_buffer(session, shape.batch * cell_runs * shape.weights() * sum_lanes, "slopes of weights")) {
    const cl::Program program = session.build(learning_source(session, shape, width_).file("learn/iteration.cl").str());
    iterate_ = cl::Kernel(program, "pelage_learn_iterate");
    reverse_ = cl::Kernel(program, "pelage_learn_reverse");
}

void LearnedIteration::iterate(const cl::Buffer& weights, const cl::Buffer& from, const cl::Buffer& to) {
    const std::size_t vectors = session_.info().processor() ? shape_.side / width_ : 1;  // a row
    Arguments(session_, iterate_).add(weights, from, to, vectors);
    launch(session_, iterate_, shape_.batch * shape_.cells() / width_ / vectors, learning_group(session_));
}

void LearnedIteration::begin_sums() {
    const std::size_t numbers = shape_.batch * cell_runs * shape_.weights() * sum_lanes;
    session_.queue().enqueueFillBuffer(sums_, cl_float{0}, 0, numbers * sizeof(cl_float));
}

void LearnedIteration::reverse(const cl::Buffer& weights, const cl::Buffer& state, const cl::Buffer& after,
                               const cl::Buffer& before) {
    const std::size_t group = learning_group(session_);
    Arguments(session_, reverse_).add(weights, state, after, before, scratch_, sums_);
    launch(session_, reverse_, shape_.batch * cell_runs * group, group);
}

}  // namespace pelage
