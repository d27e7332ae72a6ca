// From the command line to an experiment that is ready to run.
#pragma once

#include "app/run_options.hpp"
#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "language/lint.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace pelage::app {

struct Prepared {
    Experiment experiment;                    // with --seed; a seed taken from the clock is written into it
    std::uint64_t last = 0;                   // where the run ends
    std::optional<Snapshot> resumed;          // the state to go on from; large, and let go once a tissue has it
    std::optional<std::uint64_t> resumed_at;  // its iteration
    std::vector<Warning> warnings;
};

// Throws Error when the file is wrong, or when a checkpoint belongs to another experiment, precision or seed, or lies
// past the end of the run.
Prepared prepare(const RunOptions&);

// Throws Error when --format asks for an EXR picture that the tissue does not make.
void check_formats(const RunOptions&, const Experiment&);

// Throws Error naming phase, chemical, rate and the largest time step that holds.
void check_stability(const Experiment&, const Snapshot& initial);

// Makes the folder and tries whether files can be written there. Throws Error when not.
void prepare_folder(const std::filesystem::path&);

// The same, and leaves no folder that was not there.
void try_folder(const std::filesystem::path&);

// The same as the first for the folder of --json; an empty path and a device are fine.
void prepare_json(const std::filesystem::path& file);

}  // namespace pelage::app
