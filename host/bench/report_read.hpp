// A report read back from the JSON that json_of() makes of it.
#pragma once

#include "bench/measure.hpp"

#include <filesystem>

namespace pelage::bench {

// Throws Error naming the file, and the member that is missing or of another type.
Report read_report(const std::filesystem::path&);

}  // namespace pelage::bench
