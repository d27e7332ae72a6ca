// The files in experiments/, for tests.
#pragma once

#include "core/experiment.hpp"

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace test {

// All of them, by name.
std::vector<std::filesystem::path> experiment_files();

std::string first_line(const std::filesystem::path&);
std::string remarks(const std::filesystem::path&);  // the lines it begins with

// Iterations at which something begins: the run, a phase, a rule, an age that a rule waits for.
std::set<std::uint64_t> beginnings(const pelage::Experiment&);

}  // namespace test
