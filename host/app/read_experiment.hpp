// Reads an experiment from the file that the command line names, or from standard input, with its warnings.
#pragma once

#include "core/experiment.hpp"
#include "language/lint.hpp"
#include "language/parse.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pelage::app {

// What stands for standard input on the command line. Its pictures and shapes are looked for in the current folder.
inline const std::string standard_input = "-";

// Throws Error as parse_experiment_file() does.
Experiment read_experiment(const std::filesystem::path&, Outline* outline = nullptr,
                           StartPictures = StartPictures::read, const std::vector<Setting>& settings = {});

// One line each, to standard error.
void print_warnings(const Experiment&, const std::vector<Warning>&);

}  // namespace pelage::app
