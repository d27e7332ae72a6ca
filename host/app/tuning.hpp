// Finds, or remembers, how a device carries out a lattice fastest: for `pelage tune`, and before long runs.
#pragma once

#include "app/machine.hpp"
#include "app/prepare.hpp"
#include "app/run_options.hpp"
#include "app/trial_worker.hpp"
#include "core/snapshot.hpp"
#include "tune/search.hpp"

#include <string>

namespace pelage::app {

// What a search tells on standard error: each candidate in turn on a terminal; in a log nothing, or one sentence.
enum class Shown { nothing, on_terminals, everywhere };

struct Tuning {
    tune::Record record;
    bool remembered = false;  // nothing had to be tried
    double seconds = 0;       // that the search took
    std::string not_kept;     // why nothing of it is remembered; empty: it is
};

tune::Key key_of(const TuningJob&);

// A complete record (an exhaustive one, when that is the effort) is taken as it is; else the search goes on where the
// record ends. It is kept on disk after each trial, unless the job's options say that nothing is.
Tuning tuned(const TuningJob&, tune::Effort, const tune::Budget&, Shown);

// Before a run on OpenCL: chooses how its lattice is carried out and makes the backend anew for it. Runs too short to
// gain by it are left alone; so is everything with --no-tune. What is chosen passes the self-test too, or is struck
// out.
void tune_machine(const RunOptions&, const Prepared&, const Snapshot& start, Machine&);

}  // namespace pelage::app
