// One experiment on two backends side by side, compared after every stretch.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"

#include <cstdint>
#include <string>

namespace pelage::verify {

struct EqualRun {
    std::string difference;  // what differs first and after which iteration; empty: nothing
    bool finite = true;      // no concentration ended as NaN or infinite
    std::size_t cells = 0;   // at the end
};

// Runs the whole experiment on both from one and the same first state, in stretches of uneven lengths drawn from
// `seed`, and compares every array after each of them, bit for bit. Once on the way, `found` is made anew from its own
// state, as a resumed run is, and now and then its state is written back to it. A NaN on both sides in one place counts
// as equal whatever its sign and payload, which machines choose differently; a NaN on one side alone does not. An Error
// thrown by either side is a difference.
EqualRun run_both(const Experiment&, Backend& expected, Backend& found, std::uint64_t seed);

// Puts 0 in the place of every pair of NaNs.
void drop_shared_nans(Snapshot&, Snapshot&);

}  // namespace pelage::verify
