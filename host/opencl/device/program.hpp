// From kernel files and emitted text to a program built for one device.
#pragma once

#include "opencl/device/cache.hpp"
#include "opencl/device/session.hpp"

#include <map>
#include <string>

namespace pelage {

// The text of kernels/NAME ("lattice/step.cl"). Throws Error when there is no such file.
const std::string& kernel_text(const std::string& name);

// Puts a program's source together, piece by piece.
class Source {
public:
    Source& file(const std::string& name);

    // As file(), with every line that consists of "//@ KEY" (after blanks) replaced by fills.at(KEY). Throws Error
    // when a key of `fills` has no such line or a line no such key.
    Source& file(const std::string& name, const std::map<std::string, std::string>& fills);

    Source& text(const std::string& emitted);

    const std::string& str() const { return text_; }

private:
    std::string text_;
};

// Of the program that build_program() makes of these.
CacheKey program_key(const Session&, const std::string& source, const std::string& options);

struct BuiltProgram {
    cl::Program program;
    bool compiled = true;  // else an earlier build was kept
};

// Builds with `options`, from the session's cache when it can. When the device's compiler refuses, throws Error with
// device, options, build log and the path of the source, which is written to the temporary folder.
BuiltProgram build_program(const Session&, const std::string& source, const std::string& options);

}  // namespace pelage
