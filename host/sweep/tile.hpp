// One tile of a sweep: a run, and what is measured of it.
#pragma once

#include "core/batch.hpp"
#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"
#include "stats/course.hpp"
#include "stats/statistics.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pelage::sweep {

struct TileOptions {
    std::uint64_t last = 0;        // iteration at which the run ends
    std::optional<double> steady;  // ends it earlier: once a hundredth of the run changes less than this
    std::function<bool()> interrupted = [] { return false; };
};

struct TileResult {
    std::uint64_t iterations = 0;
    stats::Verdict verdict = stats::Verdict::uniform;
    std::optional<std::uint64_t> settled;  // from where on each twentieth of the run changes less than a thousandth
    std::optional<stats::Statistics> statistics;  // none where there are NaNs, in the state or in what is shown
    std::string hash;                             // of all concentrations of the final state: SHA-256, 16 digits
    std::string of;                               // what the statistics are of: measured() of the experiment
    Snapshot state;                               // the final one
};

// What the tile shows of a state: what the experiment's first picture of colours draws, of `rgb` the reds, then the
// greens and blues.
std::vector<double> shown(const Experiment&, const Snapshot&);

// What of it is measured: the name of a chemical, "formula" or, of `rgb`, "red".
std::string measured(const Experiment&);

// The first 16 digits of the SHA-256 of the concentrations as little-endian doubles, chemical after chemical.
std::string hash_of(const Snapshot&);

// Empty: it was interrupted. The tissue is at iteration 0. What is shown is measured at twenty moments, and in the last
// tenth at eight more for the verdict; reading changes no bit.
std::optional<TileResult> run_tile(Tissue&, const Experiment&, const TileOptions&);

// The same of every member of a batch; `finished` is told of each when it ends, some earlier than others. False: it was
// interrupted.
bool run_tiles(Batch&, const std::vector<const Experiment*>&, const TileOptions&,
               const std::function<void(std::size_t member, TileResult)>& finished);

// Throws Error for free cells, which have no rows and columns to measure in.
void check_measurable(const Experiment&);

}  // namespace pelage::sweep
