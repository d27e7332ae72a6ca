// Programs for PoCL without clang's header of all built-in functions, which PoCL reads anew for each of them.
#pragma once

#include "opencl/device/session.hpp"

#include <optional>
#include <string>

namespace pelage {

struct ProgramText {
    std::string source;
    std::string options;
};

// The same program with kernels/pocl/builtins.cl in the header's place; lines keep their numbers. Nothing where the
// session's device is not PoCL's CPU, or the developer's variable PELAGE_POCL_HEADER is "always".
std::optional<ProgramText> without_header(const Session&, const std::string& source, const std::string& options);

// Whether a program that cannot be built so is built with the header: unless PELAGE_POCL_HEADER is "never".
bool header_may_help();

}  // namespace pelage
