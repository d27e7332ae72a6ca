// The texts of kernels/**/*.cl: those embedded at build time, or for a developer those of a folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace pelage {

// File name relative to kernels/ ("lattice/step.cl", "models/turing.cl") -> text. Where the environment has
// PELAGE_KERNELS, a folder's name, its files of these names take the place of the embedded ones. Throws Error where one
// of them cannot be read.
const std::map<std::string, std::string>& kernel_sources();

const std::map<std::string, std::string>& embedded_kernels();

std::string kernels_folder();  // PELAGE_KERNELS; empty: not set

// Adds a line to the file that the environment names in PELAGE_KERNELS_LOG, if any: a program was put together of this.
void log_kernel(const std::string& name);
std::map<std::string, std::string> read_kernels(const std::filesystem::path& folder);

}  // namespace pelage
