// The kinds of files that show a state: one table, from which the command line, results and their tidying take them.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pelage {

enum class Format {
    exr,  // STEM.exr: a lattice's concentrations, and in Y the first output's chemical, which other programs show
    png,  // STEM.png: the first output of colours; STEM.NAME.png: the others, by chemical or name (STEM.NAME-2.png if
          // that is taken); STEM.NAME.height.png and STEM.NAME.normal.png: maps of a lattice
    npy,  // STEM.NAME.npy for each chemical: rows x columns, bottom row first, or one dimension for free cells
    csv,  // STEM.csv
    vtk,  // STEM.vti for a lattice, STEM.vtp for free cells and meshes
    ply   // STEM.ply: a mesh in the colours of the first output of colours
};

// A file that shows a whole state, STEM with this ending.
struct StateFile {
    const char* ending = nullptr;
    void (*write)(const std::filesystem::path&, const Snapshot&, const Experiment&, Precision) = nullptr;
};

struct FormatRow {
    Format format;
    std::vector<std::string> words;  // on the command line; the first is the usual one
    StateFile lattice, cells, mesh;  // without a writer: the files have a plan of their own, in result_plan.cpp
};

// In the order in which files are written.
const std::vector<FormatRow>& format_table();

// The usual word of each.
std::vector<std::string> format_words();

// The endings of all files that a format gives.
std::vector<std::string> format_endings();

// "exr,png,npy,csv,vti": a list with commas. Throws Error on words that are in no row.
std::vector<Format> parse_formats(const std::string& list);

}  // namespace pelage
