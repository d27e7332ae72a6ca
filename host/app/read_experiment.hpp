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

// The text that the command line names, at most largest_text bytes and one. Throws Error where it cannot be read.
std::string experiment_text(const std::filesystem::path&);

// The experiment of a text that was read before; its pictures and shapes are looked for beside that file. Throws Error
// as parse_experiment() does.
Experiment experiment_of(const std::string& text, const std::filesystem::path&, StartPictures = StartPictures::read,
                         const std::vector<Setting>& settings = {}, Outline* outline = nullptr);

// Both in one.
Experiment read_experiment(const std::filesystem::path&, Outline* outline = nullptr,
                           StartPictures = StartPictures::read, const std::vector<Setting>& settings = {});

// One line each, to standard error.
void print_warnings(const Experiment&, const std::vector<Warning>&);

}  // namespace pelage::app
