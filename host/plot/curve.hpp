// The loss curve of a training.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace pelage::bench {

// {"title": text, "x": [steps], "y": [losses]}; on both axes equal factors are equally far apart.
void draw_curve(const nlohmann::json&, const std::filesystem::path&);

}  // namespace pelage::bench
