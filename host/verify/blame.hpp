// Which rules of an experiment a difference needs.
#pragma once

#include "verify/check.hpp"

#include <cstdint>
#include <string>

namespace pelage::verify {

// An experiment that ends differently on the device and in the reference.
struct Suspect {
    const Experiment& experiment;
    const std::string& text;   // of the experiment, whose rules have their lines in it
    const Snapshot& start;     // for free cells and lattices alike
    std::uint64_t iterations;  // after which it differs
};

// What a report says of it, in lines: some rules, mostly one, with which it differs without the others, found by
// halving; or that it needs no rule. Empty where it needs rules of both halves. Ends after some seconds: each trial is
// another program.
std::string blame(const Suspect&, Place&, const Setting&);

}  // namespace pelage::verify
