// The threads of a process that run tiles of a sweep.
#pragma once

#include "app/machine.hpp"
#include "app/sweeper.hpp"
#include "app/tile_runner.hpp"
#include "cluster/ranks.hpp"
#include "sweep/share.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace pelage::app {

// The machines that a sweep runs on: with --device all every usable device, software rasterisers only where there is
// nothing else. Where none is asked for, the ranks of one machine take its cards in turn. Throws Error as
// choose_machine().
std::vector<Machine> sweep_machines(const RunOptions&, const Experiment&, const Footprint&, const cluster::Ranks*);

struct Crew {
    Machine& machine;
    Precision precision;
    std::size_t jobs;    // threads that run tiles
    bool whole_machine;  // one tile takes all of it; else each has one processor
    std::size_t batch;   // tiles that a thread takes at one time
};

// What is the same for all tiles: of the first one.
struct TileSize {
    Footprint footprint;
    std::uint64_t last = 0;  // iteration
    std::size_t tiles = 0;
};

// Small tiles on processors run side by side, each on one of them: strips that wait for each other would cost more.
// Small ones on a card run in batches, too. The ranks of one machine share its processors. Throws Error where batches
// are asked of the reference.
Crew crew(Machine&, const SweepOptions&, const TileSize&, const cluster::Ranks*);

// They run until the share has no further tile; what goes wrong in one ends all. The end of the object waits for them.
class Workers {
public:
    Workers(const std::vector<Crew>&, sweep::Share&, const TileRunner&);

private:
    std::vector<std::unique_ptr<Backend>> backends_;
    std::vector<std::jthread> threads_;
};

}  // namespace pelage::app
