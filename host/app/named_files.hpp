// Files that a command would write over what it reads.
#pragma once

#include "app/run_options.hpp"
#include "core/experiment.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pelage::app {

// Whether both name one file, there or not; an empty path names none.
bool same_file(const std::filesystem::path&, const std::filesystem::path&);

// Throws Error: "OPTION FILE is what WHAT; name another file", where the file is one of those that are read.
void keep_inputs(const std::string& option, const std::filesystem::path& file,
                 const std::vector<std::filesystem::path>& read, const std::string& what);

// The experiment's file, what it includes, what it starts from.
std::vector<std::filesystem::path> files_read(const std::filesystem::path& file, const Experiment&);

// Throws Error where --json, --video or the results would replace what the run reads, or --video the file of --json.
void check_named_files(const RunOptions&, const Experiment&);

}  // namespace pelage::app
