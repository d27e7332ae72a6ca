// What programs that carry out rules are built with beyond Session::build_options().
#pragma once

#include "opencl/device/session.hpp"

#include <string>

namespace pelage {

// The arithmetic of processors has taken subnormal numbers for 0 before a function sees them: it need not look again,
// which costs a `clamp` a fifth of its time and more. Other devices may keep some.
inline std::string rule_options(const Session& session) {
    return !session.is_double() && session.info().processor() ? "-DPELAGE_FLUSHED" : "";
}

}  // namespace pelage
