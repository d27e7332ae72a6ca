// manifest.json: everything needed to do a run again, and how long it took.
#pragma once

#include "core/experiment.hpp"
#include "core/tissue.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

// In UTC, as "2026-01-31T12:00:00Z".
std::string iso_time(std::chrono::system_clock::time_point);

struct OptionGiven {  // one option of the command line
    std::string name;
    bool flag = false;                 // it has no value
    std::optional<std::string> value;  // empty: not given
};

struct Manifest {
    std::string backend;   // "reference" or "opencl"
    std::string device;    // name
    std::string driver;    // version
    std::string platform;  // name
    Precision precision = Precision::single_;
    std::int64_t seed = 1;
    std::uint64_t iterations = 0;  // where the run has come to
    double time = 0.0;             // simulated until then
    std::size_t cells = 0;         // in the end
    std::size_t columns = 0;       // 0 for free cells
    std::size_t rows = 0;
    double seconds = 0.0;             // of stepping
    double updates_per_second = 0.0;  // cell updates
    std::string version;
    std::string build_options;
    bool fast = false;
    std::vector<OptionGiven> options;  // all there are
    std::vector<std::string> files;    // relative to the manifest's folder
    std::chrono::system_clock::time_point started;
    std::map<std::string, std::string> more_texts;  // further entries, by key
    std::map<std::string, double> more_numbers;     // a NaN or infinity becomes null
    std::map<std::string, std::uint64_t> more_counts;
};

// The JSON object, indented: the fields above by name (precision "float" or "double", started as ISO 8601 in UTC;
// options by name: a flag true or false, else the value or null), "parameters" by name, "inputs" [{"file", "sha256" or
// null}], "experiment"
// {"source", "text"} and "phases" [names]. Text that is not UTF-8 is mended.
std::string manifest_text(const Manifest&, const Experiment&);

// Writes it; the file appears whole or not at all. Throws Error naming file and reason.
void write_manifest(const std::filesystem::path&, const Manifest&, const Experiment&);

}  // namespace pelage
