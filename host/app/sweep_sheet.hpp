// The contact sheet of a sweep as a file.
#pragma once

#include "core/experiment.hpp"
#include "sweep/design.hpp"
#include "sweep/sheet.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pelage::app {

// Writes sheet.png (.svg, .pdf): the tiles, names and values of the axes, a bar of colours but of `rgb`. Where
// pelage-plot is not built it is a PNG of the tiles alone; the note says so. Throws Error when it cannot be written.
std::string draw_sheet(const std::filesystem::path& folder, const Experiment&, const std::vector<sweep::Axis>&,
                       std::size_t replicates, const std::vector<sweep::TilePicture>&, std::size_t across,
                       const std::string& ending, const std::string& title);

}  // namespace pelage::app
