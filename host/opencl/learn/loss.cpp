// See loss.hpp.
#include "opencl/learn/loss.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/learn/settings.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage {

namespace {

double share_of(const LearningShape& shape, std::size_t level) {
    return 1.0 / static_cast<double>(shape.level_cells(level) * patch_directions);
}

std::vector<float> shares_of(const LearningTask& task) {
    std::vector<float> shares;
    for (std::size_t level = 0; level < pyramid_levels; ++level)
        shares.push_back(static_cast<float>(share_of(task.shape, level)));
    shares.push_back(static_cast<float>(task.overflow / static_cast<double>(task.shape.cells())));
    return shares;
}

std::vector<float> factors_of(const LearningShape& shape) {
    std::vector<float> factors;
    for (std::size_t level = 0; level < pyramid_levels; ++level)
        factors.push_back(static_cast<float>(2 * share_of(shape, level) / static_cast<double>(shape.batch)));
    return factors;
}

}  // namespace

LearningJudge::LearningJudge(const Session& session, const LearningTask& task)
    : session_(session),
      shape_(task.shape),
      shared_(shared_learning(session)),
      lists_(task.shape.batch * pyramid_levels * patch_directions),
      push_(task.overflow / static_cast<double>(task.shape.cells()) / static_cast<double>(task.shape.batch)),
      directions_(filled_buffer(session, task.directions, "directions of patches")),
      ranked_(filled_buffer(session, task.ranked, "target")),
      shares_(filled_buffer(session, shares_of(task), "weights of losses")),
      factors_(filled_buffer(session, factors_of(task.shape), "weights of slopes")) {
    const std::size_t pixels = shape_.batch * shape_.level_begin(pyramid_levels), seen = pixels * patch_directions;
    pictures_ = float_buffer(session, pixels * picture_colours, "pictures");
    picture_slopes_ = float_buffer(session, pixels * picture_colours, "slopes of pictures");
    for (cl::Buffer* one : {&seen_, &order_, &aside_, &sorted_, &along_numbers_})
        *one = float_buffer(session, seen, "what patches have along directions");
    apart_numbers_ = float_buffer(session, lists_ * shape_.rotations, "distances");
    excess_numbers_ = float_buffer(session, shape_.batch * cell_runs, "excesses");
    losses_ = float_buffer(session, shape_.batch, "losses");
    rotations_ = session.buffer(shape_.batch * sizeof(cl_int), "rotations");
    Source source =
        learning_source(session, shape_, learning_width(session)).file("learn/iteration.cl").file("learn/loss.cl");
    if (shared_) source.file("learn/loss_lanes.cl");
    const cl::Program program = session.build(source.str());
    const auto kernel = [&](std::string name) {
        return cl::Kernel(program, (name + (shared_ ? "_together" : "")).c_str());
    };
    shrink_ = cl::Kernel(program, "pelage_learn_shrink");
    look_ = cl::Kernel(program, "pelage_learn_look");
    rank_ = kernel("pelage_learn_rank");
    apart_ = kernel("pelage_learn_apart");
    excess_ = kernel("pelage_learn_excess");
    nearest_ = kernel("pelage_learn_nearest");
    along_ = cl::Kernel(program, "pelage_learn_along");
    slopes_ = cl::Kernel(program, "pelage_learn_slopes");
    begin_ = cl::Kernel(program, "pelage_learn_begin");
}

void LearningJudge::launch_rows(cl::Kernel& kernel, std::size_t level, std::size_t many) {
    const std::size_t side = shape_.level_side(level);
    const std::size_t pieces = shared_ ? (side + many - 1) / many : 1;
    launch(session_, kernel, shape_.batch * side * pieces, learning_group(session_));
}

void LearningJudge::look(const cl::Buffer& states, std::size_t set) {
    constexpr std::size_t beside = 4;  // pixels that a work-item takes at once
    for (std::size_t level = 0; level < pyramid_levels; ++level) {
        const std::size_t many = shared_ ? beside : shape_.level_side(level);
        Arguments(session_, shrink_).add(states, pictures_, level);
        launch(session_, shrink_, shape_.batch * picture_colours * shape_.level_cells(level), 64);
        Arguments(session_, look_).add(pictures_, directions_, set, seen_, level, many);
        launch_rows(look_, level, many);
    }
}

void LearningJudge::rank() {
    if (shared_) {
        Arguments(session_, rank_).add(seen_, order_, sorted_);
        const std::size_t group = std::min<std::size_t>(4 * learning_group(session_), session_.info().max_work_group);
        launch(session_, rank_, lists_ * group, group);
    } else {
        Arguments(session_, rank_).add(seen_, order_, aside_, sorted_);
        launch(session_, rank_, lists_);
    }
}

void LearningJudge::compare(const cl::Buffer& states, std::size_t set) {
    Arguments(session_, apart_).add(sorted_, ranked_, set, apart_numbers_);
    launch(session_, apart_, shared_ ? lists_ * shape_.rotations * sum_lanes : lists_, shared_ ? sum_lanes : 1);
    Arguments(session_, excess_).add(states, excess_numbers_);
    launch(session_, excess_, shape_.batch * cell_runs * (shared_ ? sum_lanes : 1), shared_ ? sum_lanes : 1);
    Arguments(session_, nearest_).add(apart_numbers_, excess_numbers_, shares_, losses_, rotations_);
    const std::size_t group = learning_group(session_);
    launch(session_, nearest_, shape_.batch * group, group);
}

void LearningJudge::go_back(const cl::Buffer& states, std::size_t set, const cl::Buffer& after) {
    const std::size_t ranks = shape_.level_cells(0), many = shared_ ? 16 : ranks, pieces = (ranks + many - 1) / many;
    Arguments(session_, along_).add(sorted_, order_, ranked_, set, rotations_, factors_, along_numbers_, many, pieces);
    launch(session_, along_, lists_ * pieces, learning_group(session_));
    for (std::size_t level = 0; level < pyramid_levels; ++level) {
        const std::size_t stretch = shared_ ? 1 : shape_.level_side(level);
        Arguments(session_, slopes_).add(along_numbers_, directions_, set, picture_slopes_, level, stretch);
        launch_rows(slopes_, level, stretch);
    }
    Arguments(session_, begin_).add(states, picture_slopes_, Scalar{push_}, after);
    launch(session_, begin_, shape_.states(), 64);
}

LearningLoss<float> LearningJudge::losses() const {
    LearningLoss<float> loss;
    loss.samples.resize(shape_.batch);
    std::vector<cl_int> rotations(shape_.batch);
    session_.queue().enqueueReadBuffer(losses_, CL_TRUE, 0, shape_.batch * sizeof(float), loss.samples.data());
    session_.queue().enqueueReadBuffer(rotations_, CL_TRUE, 0, shape_.batch * sizeof(cl_int), rotations.data());
    loss.rotations.assign(rotations.begin(), rotations.end());
    for (const float one : loss.samples) loss.total = loss.total + one;
    loss.total = loss.total * static_cast<float>(1.0 / static_cast<double>(shape_.batch));
    return loss;
}

LearningLoss<float> LearningJudge::judge(const cl::Buffer& states, std::size_t set, const cl::Buffer& after) {
    look(states, set);
    rank();
    compare(states, set);
    go_back(states, set, after);
    return losses();
}

}  // namespace pelage
