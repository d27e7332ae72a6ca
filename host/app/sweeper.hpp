// The driver of `pelage sweep`: runs tiles, keeps what is measured of each, and draws the contact sheet.
#pragma once

#include "app/run_options.hpp"
#include "sweep/design.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pelage::app {

struct SweepOptions {
    RunOptions run;  // file, backend, device, precision, settings, iterations, seed, out, formats, quiet, force ...
    std::vector<std::string> vary;
    std::filesystem::path points;  // a table instead of --vary
    std::size_t samples = 0;       // drawn within the ranges of --vary; 0: their grid
    bool latin = false;
    std::size_t replicates = 1;
    std::vector<std::string> until;  // empty, or "steady" and a tolerance
    std::string sheet = "png";
    std::size_t across =
        0;  // tiles of a design without axes side by side in the sheet; 0: about as many as one upon another
    std::size_t jobs = 0;   // tiles at one time; 0: as many as processors, where tiles are small and run on them
    std::size_t batch = 0;  // tiles of one launch; 0: ours to choose
};

// Returns the exit code. Throws Error when the sweep cannot begin or its results cannot be written.
int run_sweep(const SweepOptions&);

}  // namespace pelage::app
