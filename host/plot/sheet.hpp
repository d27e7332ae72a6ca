// The contact sheet of a sweep: tiles in a picture, with axes, values, a bar of colours and a title.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace pelage::plot {

// What `pelage sweep` says of it: title; mosaic, the tiles' PNG; tile [columns, rows] and gap in pixels; layout
// [across, down]; x and y with name and values, the values of y from below (or no axes); range [low, high]; colours of
// the bar from low to high. The file's ending says its kind: .png, .svg or .pdf. Throws Error naming the file.
void draw_sheet(const nlohmann::json&, const std::filesystem::path&);

}  // namespace pelage::plot
