// All files that show one state of a tissue: what a run leaves behind in the end and at every snapshot.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"
#include "io/attributes.hpp"
#include "io/colour.hpp"
#include "io/draw_cells.hpp"
#include "io/exr.hpp"
#include "io/format.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

struct ResultOptions {
    std::vector<Format> formats{Format::exr, Format::png, Format::ply};
    Precision precision = Precision::single_;  // numbers in .npy, .vti and .vtp
    Attributes attributes;                     // for EXR headers; "iteration" and "time" are added
    CellDrawing drawing;                       // of free cells
    ExrType exr_type = ExrType::float_;
    bool deep_png = false;  // 16 bits a channel; the colours of free cells are still those of 8
    // The range in which each output draws where it has none of its own; shorter, or empty: that of its values.
    std::vector<std::optional<ValueRange>> ranges;
    // What each output draws where it is not taken from the state; shorter, or empty: it is.
    std::vector<std::optional<std::vector<double>>> values;
    std::size_t enlargement = 0;  // of a lattice's pictures; 0: that of its own size
    bool ranged_only = false;     // of the pictures, only those of outputs that are given a range here
    std::function<void(const std::vector<std::string>&)> before;  // told all names before anything is written
    std::function<void(const std::string&)> begins;               // told a name when its file is begun; one at a time
};

// Writes STEM.* into the folder, which is made when it is not there; large files at the same time. With
// Experiment::texture also texture.exr, texture.png and the maps (STEM.texture.* unless the stem is "final") for the
// formats exr and png. Returns the names of the files, relative to the folder. Throws Error naming the file that cannot
// be written, or when the snapshot's arrays do not fit the experiment.
std::vector<std::string> write_results(const std::filesystem::path& folder, const std::string& stem, const Snapshot&,
                                       const Experiment&, const ResultOptions&);

}  // namespace pelage
