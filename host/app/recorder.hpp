// All files of one run: results, snapshots, checkpoints and the manifest.
#pragma once

#include "app/ledger.hpp"
#include "app/machine.hpp"
#include "app/prepare.hpp"
#include "app/reel.hpp"
#include "app/run_options.hpp"
#include "core/neighbours.hpp"
#include "core/tissue.hpp"
#include "io/manifest.hpp"
#include "io/results.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
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
    std::optional<ProgramCounts> programs;
    std::uint64_t frames = 0;  // of the film
    double film_seconds = 0;   // that the run waited for it
    double updates_per_second() const { return seconds > 0 ? updates / seconds : 0; }
};

class Recorder {
public:
    // `tell` hears the name of each file when it is begun, and whether it is large. `resumed_at`: the iteration of the
    // checkpoint; `last`: where the run ends, whose lattice says how much all pictures are enlarged.
    Recorder(const RunOptions&, const Experiment&, const Machine&, std::optional<std::uint64_t> resumed_at,
             std::uint64_t last, std::function<void(const std::string&, bool)> tell);

    void snapshot(const Snapshot&);                     // ITERATION.*
    void results(const Snapshot&);                      // final.*
    std::filesystem::path checkpoint(const Snapshot&);  // checkpoint.pelage, over the one before
    std::filesystem::path dump(const Snapshot&);        // non-finite.pelage
    void settle();  // snapshots' pictures that were drawn in another range than the last ones are drawn anew
    void manifest(const Snapshot&, const Tally&, const char* end);  // manifest.json and --json

    const std::filesystem::path& folder() const { return folder_; }
    const CellDrawing& drawing() const { return result_options_.drawing; }

    // In one sentence, of pictures from before the checkpoint that cannot share the colours of those to come; empty:
    // none.
    const std::string& warning() const { return warning_; }

private:
    void write(const Snapshot&, const std::string& stem, const SharedRanges&, const std::vector<Format>&);
    std::filesystem::path save(const Snapshot&, const char* name) const;
    void write_drawn();  // the experiment that --random drew
    std::string lost_colours() const;
    Manifest facts() const;  // those of the run that do not change

    const RunOptions& options_;
    const Experiment& experiment_;
    const Machine& machine_;
    std::filesystem::path folder_;
    ResultOptions result_options_;
    std::function<void(const std::string&, bool)> tell_;
    std::string identity_;
    Ledger ledger_;
    Reel reel_;
    std::string warning_;
    std::chrono::system_clock::time_point started_ = std::chrono::system_clock::now();
    double writing_ = 0;  // seconds
};

}  // namespace pelage::app
