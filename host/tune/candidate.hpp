// One way among those that give the same bits to carry out a lattice's iterations on a device.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/options.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace pelage::tune {

struct Candidate {  // as it is made: what a run takes without tuning
    Path path = Path::automatic;
    std::size_t width = 0;
    LatticeCut cut;  // a single step has a group alone

    bool operator==(const Candidate&) const = default;
    std::string text() const;  // "streamed, width 16, depth 24, 256 columns, blocks of 8 rows"; "defaults"
};

OpenclOptions applied(const Candidate&, OpenclOptions);

// One launch an iteration, one cell a work-item: what every other candidate's bits are compared with.
Candidate single_step();

nlohmann::ordered_json to_json(const Candidate&);
Candidate candidate_from_json(const nlohmann::ordered_json&);  // throws Error

enum class Effort { quick, exhaustive };

// What to try on a device: the defaults first, then what promises most and differs most, then, when exhaustive, the
// rest. Without doubles.
std::vector<Candidate> candidates(const DeviceInfo&, Precision, Effort);

}  // namespace pelage::tune
