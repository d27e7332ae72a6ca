// What the command line of `pelage run` asks for.
#pragma once

#include "core/neighbours.hpp"
#include "core/tissue.hpp"
#include "io/manifest.hpp"
#include "io/results.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pelage::app {

// The film that a run leaves, as the command line wants it.
struct VideoOptions {
    std::filesystem::path file;  // empty: none
    std::string of;              // the output that is filmed; empty: the first one of colours
    std::uint64_t every = 0;     // iterations from frame to frame; 0: as fit a film of 20 seconds
    std::uint64_t fps = 30;      // frames a second
    std::string size;            // "WIDTHxHEIGHT" of a frame; empty: that of the pictures
};

struct RunOptions {
    std::string command = "pelage";  // as the user called it
    std::filesystem::path file;
    std::string backend;  // "reference", "opencl", or empty: opencl where a device is usable
    std::string device;   // index in `pelage devices` or part of a name; empty: the first usable one
    Precision precision = Precision::single_;
    std::string neighbours = "bins";  // search of free cells: bins, kd-tree or spatial-sorting
    SpatialSorting sorting;
    std::vector<std::string> settings;    // NAME=VALUE
    std::optional<std::uint64_t> random;  // draw of all parameters that have ranges
    std::optional<std::uint64_t> iterations;
    std::optional<std::int64_t> seed;
    std::filesystem::path out;  // empty: out/STEM of the file
    std::string formats;        // empty: exr,png,ply
    std::string exr_type = "float";
    std::string png_bits = "8";
    std::uint64_t snap_every = 0;        // 0: only as the experiment says
    std::uint64_t checkpoint_every = 0;  // 0: only when interrupted
    std::filesystem::path resume;        // empty: from the start
    std::filesystem::path json;          // empty: only DIR/manifest.json
    std::string cells = "circle";        // how free cells are drawn: circle, hexagon or voronoi
    bool polarity_marks = false;
    VideoOptions video;
    bool quiet = false;
    bool fast = false;
    bool no_cache = false;
    bool explain = false;
    bool no_self_test = false;
    bool no_tune = false;
    bool force = false;
    std::vector<OptionGiven> given;  // all options of the command line, for the manifest

    NeighbourSearch neighbour_search() const;
    std::vector<Format> format_list() const;
    std::filesystem::path folder() const;  // `out`, or its default
};

// The command that goes on from `checkpoint`, of this iteration, with the same options, quoted for a POSIX shell. A
// film goes on in a file of its own.
std::string resume_command(const RunOptions&, const std::filesystem::path& checkpoint, std::uint64_t iteration,
                           std::int64_t seed);

// One word of a POSIX shell.
std::string shell_quoted(const std::string&);

}  // namespace pelage::app
