// What a film shows, when, and in which form: settled before a run begins.
#pragma once

#include "app/run_options.hpp"
#include "core/experiment.hpp"
#include "io/frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pelage::app {

struct FrameSize {  // in pixels, both even
    std::size_t columns = 0;
    std::size_t rows = 0;
};

// "640x480". Throws Error naming what is allowed.
FrameSize parse_frame_size(const std::string&);

struct FilmPlan {
    std::filesystem::path file;
    std::uint64_t every = 1;  // iterations from frame to frame
    std::uint64_t fps = 30;
    std::uint64_t last = 0;  // iteration of the last frame
    Output output;
    std::size_t place = 0;           // of the output in Experiment::outputs
    bool texture = false;            // instead of cells
    bool plain = false;              // a chemical of a lattice, cell by cell: all that a frame needs of the state
    std::optional<FrameSize> frame;  // empty, of free cells: that of the first picture
    std::optional<Scale> scale;      // of a lattice's pictures; empty: as fits each picture

    // The next iteration after this one that is filmed.
    std::uint64_t next(std::uint64_t iteration) const;
    bool rgb() const;  // what ffmpeg is given: RGB, or brightness and colour differences
    std::vector<std::string> arguments(const FrameSize&, const std::filesystem::path& to) const;  // of ffmpeg
};

// What --video asks for; nothing without it. Throws Error when it cannot be.
std::optional<FilmPlan> plan_film(const RunOptions&, const Experiment&, std::uint64_t last);

}  // namespace pelage::app
