// All files that show one state of a tissue: what a run leaves behind in the end and at every snapshot.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"
#include "io/attributes.hpp"
#include "io/draw_cells.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pelage {

enum class Format {
    exr,  // STEM.exr: a lattice's concentrations
    png,  // STEM.png: the first output; STEM.NAME.png: the others, by chemical (STEM.NAME-2.png if that name is taken)
    npy,  // STEM.NAME.npy for each chemical: rows x columns, bottom row first, or one dimension for free cells
    csv,  // STEM.csv
    vtk   // STEM.vti for a lattice, STEM.vtp for free cells
};

// "exr,png,npy,csv,vti": a list with commas; "vtp" and "vtk" mean the same as "vti". Throws Error on other words.
std::vector<Format> parse_formats(const std::string& list);

struct ResultOptions {
    std::vector<Format> formats{Format::exr, Format::png};
    Precision precision = Precision::single_;  // numbers in .npy, .vti and .vtp
    Attributes attributes;                     // for EXR headers; "iteration" is added
    CellDrawing drawing;                       // of free cells
};

// Writes STEM.* into the folder, which is made when it is not there. With Experiment::texture also texture.exr and
// texture.png (STEM.texture.* unless the stem is "final") for the formats exr and png. Returns the names of the files,
// relative to the folder. Throws Error naming the file that cannot be written, or when the snapshot's arrays do not fit
// the experiment.
std::vector<std::string> write_results(const std::filesystem::path& folder, const std::string& stem, const Snapshot&,
                                       const Experiment&, const ResultOptions&);

// The iteration with zeros in front, as wide as the last iteration: names sort as the run went, as ffmpeg's
// -pattern_type glob needs it.
std::string snapshot_stem(std::uint64_t iteration, std::uint64_t last_iteration);

}  // namespace pelage
