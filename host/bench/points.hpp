// The neighbours suite: exact sets of points, by nanoflann's k-d tree and by bins on a device.
#pragma once

#include "bench/task.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace pelage::bench {

struct Points {
    std::vector<double> x, y;  // exact as float
};

// As dense as a hexagonal tissue with cells 2 apart: such a tissue with jitter, ids row by row; or, shuffled, uniformly
// random places in no order.
Points make_points(std::size_t count, bool shuffled);

// One iteration builds the tree and finds the neighbours of every point, in whatever order the tree gives them.
// threads: 1, or as many as OpenMP has (the tree is built by one).
std::unique_ptr<Task> nanoflann_search(const Points&, bool all_threads);

// The reference's own search, a list for each point ascending by id.
std::unique_ptr<Task> reference_search(const Points&);

// One iteration sorts the points into bins and finds their lists, all on the device.
std::unique_ptr<Task> opencl_search(std::shared_ptr<const Session>, const Points&);

}  // namespace pelage::bench
