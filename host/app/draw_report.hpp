// The pictures of a report of `pelage bench`, drawn by a program beside this one.
#pragma once

#include <filesystem>

namespace pelage::app {

// Throws Error when there is no pelage-plot beside this program: it is built where cairo is installed.
void require_plotter();

// Draws PICTURE.roofline.png and PICTURE.scaling.png of the JSON file. Throws Error when that fails; the reason stands
// on standard error.
bool plotter_is_there();
void draw_report(const std::filesystem::path& json, const std::filesystem::path& picture);

}  // namespace pelage::app
