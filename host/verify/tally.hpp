// How far a device's values are from the reference's, counted.
#pragma once

#include "core/snapshot.hpp"
#include "core/tissue.hpp"
#include "io/checksum.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace pelage::verify {

// Values differ when any bit does: +0 and -0 do. Two NaNs of any bits are the same value: a device may choose them.
struct Tally {
    std::uint64_t cells_compared = 0;
    std::uint64_t cells_differing = 0;  // in any of their values
    std::uint64_t max_ulp = 0;          // steps of the run's precision between two values; integers: the difference
    double max_absolute = 0.0;
    double max_relative = 0.0;   // |difference| / |expected|
    double max_scaled = 0.0;     // |difference| / max(1, |expected|)
    bool same_structure = true;  // numbers of cells, and all that is counted in integers
    std::string first;           // the first cell that differs, with both values; empty: none
    Checksum found;              // of all that the device gave

    bool equal() const { return cells_differing == 0 && first.empty(); }
};

// Adds what two states of a tissue of this precision show, cell by cell. `where` begins the text of a difference.
void add(Tally&, const Snapshot& expected, const Snapshot& found, Precision, const std::string& where);

// The same for arrays, one value a cell; `what` names their contents.
void add(Tally&, std::span<const float> expected, std::span<const float> found, const std::string& what);
void add(Tally&, std::span<const double> expected, std::span<const double> found, const std::string& what);
void add(Tally&, std::span<const std::uint32_t> expected, std::span<const std::uint32_t> found,
         const std::string& what);

// Steps of a float (double) between two values, both finite or equal; otherwise the largest number there is.
std::uint64_t ulps(double expected, double found, Precision);

}  // namespace pelage::verify
