// The experiment language: from the text of a .pex file to a checked Experiment.
#pragma once

#include "core/experiment.hpp"
#include "language/outline.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace pelage {

inline constexpr std::size_t largest_text = 16u << 20;            // bytes of one experiment
inline constexpr std::size_t largest_line = 1u << 20;             // bytes
inline constexpr std::size_t largest_snapshot_count = 1'000'000;  // of one run
inline constexpr std::size_t largest_phase_count = 10'000;
inline constexpr std::size_t largest_mapping_count = 64;  // each costs a number a cell

// left_out: those of chemicals are not opened, for a run that goes on from a later state; there is no Chemical::initial
// then. Those of fields are read all the same.
enum class StartPictures { read, left_out };

// Parses and validates. `source_name` stands in messages; names of pictures and shapes that are not absolute are
// looked for in `folder`. Throws Error "SOURCE:LINE:COLUMN: what was found; what is allowed", columns counted in
// characters from 1. `settings` are values for parameters that the text defines, and enter Experiment::text. `outline`
// is told where everything stands; lint.hpp makes warnings of it.
Experiment parse_experiment(const std::string& text, const std::string& source_name,
                            const std::filesystem::path& folder, Outline* outline = nullptr,
                            StartPictures = StartPictures::read, const std::vector<Setting>& settings = {});

// The same from a file; pictures and shapes are looked for beside it.
Experiment parse_experiment_file(const std::filesystem::path&, Outline* = nullptr, StartPictures = StartPictures::read,
                                 const std::vector<Setting>& settings = {});

}  // namespace pelage
