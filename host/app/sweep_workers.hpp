// The threads of a process that run tiles of a sweep.
#pragma once

#include "app/machine.hpp"
#include "app/sweeper.hpp"
#include "app/tile_runner.hpp"
#include "cluster/ranks.hpp"
#include "sweep/share.hpp"

#include <cstddef>
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
    std::size_t jobs;    // tiles at one time
    bool whole_machine;  // one tile takes all of it; else each has one processor
};

// Tiles of so many cells, of which small ones on processors run side by side, each on one of them: strips that wait for
// each other would cost more. The ranks of one machine share its processors.
Crew crew(Machine&, const SweepOptions&, double cells, std::size_t tiles, const cluster::Ranks*);

// They run until the share has no further tile; what goes wrong in one ends all. The end of the object waits for them.
class Workers {
public:
    Workers(const std::vector<Crew>&, sweep::Share&, const TileRunner&);

private:
    std::vector<std::unique_ptr<Backend>> backends_;
    std::vector<std::jthread> threads_;
};

}  // namespace pelage::app
