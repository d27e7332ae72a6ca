// Tasks that advance a Tissue: the reference's, or a device's.
#pragma once

#include "bench/task.hpp"
#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"
#include "opencl/device/session.hpp"

#include <cstdint>
#include <memory>

namespace pelage::bench {

// What is compared of a state: concentrations, places of free cells, and how many cells there are.
Outcome outcome_of(const Snapshot&);

std::unique_ptr<Task> reference_task(const Experiment&, std::shared_ptr<const Snapshot> initial);
std::unique_ptr<Task> opencl_task(std::shared_ptr<const Session>, const Experiment&,
                                  std::shared_ptr<const Snapshot> initial);

// Updates of cells that `iterations` iterations from the first state make, the tissue growing as it goes; sampled
// 64 times.
double count_updates(std::shared_ptr<const Session>, const Experiment&, const Snapshot& initial,
                     std::uint64_t iterations);

}  // namespace pelage::bench
