// What programs that carry out rules are built with beyond Session::build_options(), and how wide.
#pragma once

#include "opencl/device/session.hpp"

#include <cstddef>
#include <string>

namespace pelage {

// The arithmetic of processors has taken subnormal numbers for 0 before a function sees them: it need not look again,
// which costs a `clamp` a fifth of its time and more. Other devices may keep some.
inline std::string rule_options(const Session& session) {
    return !session.is_double() && session.info().processor() ? "-DPELAGE_FLUSHED" : "";
}

// Cells that a work-item takes side by side where they are no lattice: as many as fit into a vector of 512 bits.
inline std::size_t lanes_for(const Session& session) {
    if (session.options().width != 0) return session.options().width;
    return session.info().processor() ? 16 : 1;
}

}  // namespace pelage
