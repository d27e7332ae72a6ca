// All files of one run: results, snapshots, checkpoints and the manifest.
#pragma once

#include "app/machine.hpp"
#include "app/prepare.hpp"
#include "app/run_options.hpp"
#include "core/neighbours.hpp"
#include "core/tissue.hpp"
#include "io/manifest.hpp"
#include "io/results.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace pelage::app {

// What a run has cost so far.
struct Tally {
    std::uint64_t started_at = 0;    // iteration
    double seconds = 0;              // of stepping, kernel compilation included
    double updates = 0;              // cells times iterations
    SearchStatistics growing;        // those of them taken while cells divided
    SearchStatistics search;         // samples of an approximate neighbour search; none of an exact one
    std::vector<std::string> notes;  // how iterations were carried out
    double updates_per_second() const { return seconds > 0 ? updates / seconds : 0; }
};

class Recorder {
public:
    Recorder(const RunOptions&, const Experiment&, const Machine&);

    void snapshot(const Snapshot&);                                 // ITERATION.*
    void results(const Snapshot&);                                  // final.*
    std::filesystem::path checkpoint(const Snapshot&);              // checkpoint.pelage, over the one before
    std::filesystem::path dump(const Snapshot&);                    // non-finite.pelage
    void manifest(const Snapshot&, const Tally&, const char* end);  // manifest.json and --json

    const std::filesystem::path& folder() const { return folder_; }

private:
    void write(const Snapshot&, const std::string& stem);
    std::filesystem::path save(const Snapshot&, const char* name) const;

    const RunOptions& options_;
    const Experiment& experiment_;
    const Machine& machine_;
    std::filesystem::path folder_;
    ResultOptions result_options_;
    std::vector<std::string> files_;
    std::chrono::system_clock::time_point started_ = std::chrono::system_clock::now();
    double writing_ = 0;  // seconds
};

}  // namespace pelage::app
