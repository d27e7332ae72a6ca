// Pictures of a difference: what the reference has, what the device has, and what lies between.
#pragma once

#include "verify/check.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pelage::verify {

// Writes NAME.reference, NAME.device and NAME.difference as .exr and .png into `folder`, which is made; "/" in the name
// becomes "-". The difference is device minus reference, drawn from blue (less) over grey (equal) to red (more), cells
// that differ by nothing but sign or NaN in magenta. Returns the files. Throws Error when one cannot be written.
std::vector<std::filesystem::path> keep_evidence(const Evidence&, const std::string& name,
                                                 const std::filesystem::path& folder);

}  // namespace pelage::verify
