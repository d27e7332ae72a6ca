// How programs of learning are cut to a shape and a device.
#pragma once

#include "core/learning.hpp"
#include "opencl/device/program.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

inline constexpr std::size_t learning_tile = 256;  // cells of a run that are on their way at a time

// Work-items of a group where many share what one does on processors; 1 there, unless the options ask for more.
std::size_t learning_group(const Session&);
inline bool shared_learning(const Session& session) { return learning_group(session) > 1; }
// Lanes of a work-item's numbers.
std::size_t learning_width(const Session&);

// Settings, prelude and sums: what every program of learning begins with. `width`: lanes.
Source learning_source(const Session&, const LearningShape&, std::size_t width);

// A buffer with these numbers. `what` names them.
cl::Buffer filled_buffer(const Session&, const std::vector<float>&, const char* what);
cl::Buffer float_buffer(const Session&, std::size_t count, const char* what);

}  // namespace pelage
