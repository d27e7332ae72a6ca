// The C++ baseline with OpenMP and simd: an honest one, written by hand for exactly the case at hand.
#pragma once

#include "bench/cases.hpp"
#include "bench/task.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace pelage::bench {

// Why there is no OpenMP here or no baseline for this case; empty: there is one.
std::string why_no_openmp(const Case&);

int openmp_threads();

// The calling thread's share of so many: from the first one up to the last.
std::pair<std::size_t, std::size_t> own_share(std::size_t count);

// Two fields, nine-point stencil, one step a pass over memory: a strip of rows each thread, sums of rows shared between
// rows. State as in the snapshot.
std::unique_ptr<Task> openmp_lattice(const Kernel&, const Experiment&, const Snapshot& initial);

// Gray-Scott in a torus of three dimensions, seven points, one step a pass over memory: a strip of rows each thread.
std::unique_ptr<Task> openmp_volume(const Experiment&, const Snapshot& initial);

// Turing's reaction at the vertices of a mesh, in the order that the device has, too: 16 cells side by side.
std::unique_ptr<Task> openmp_mesh(const Experiment&, const Snapshot& initial);

// A network that is asked for every cell of a torus, nine-point stencil, three rows or more: a strip of rows each
// thread, 16 cells side by side.
std::unique_ptr<Task> openmp_network(const Experiment&, const Snapshot& initial);

// Two chemicals, Turing reaction, collision: neighbour lists with a skin, reused until a cell has moved half of it;
// cells sorted by bins, 16 side by side.
std::unique_ptr<Task> openmp_cells(const Experiment&, const Snapshot& initial);

// Charges of one eta: candidates in places, a share of them each thread, three barriers a particle.
std::unique_ptr<Task> openmp_aggregate(const Experiment&, const Snapshot& initial);

}  // namespace pelage::bench
