// Named numbers of an experiment, which can be set from outside.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace pelage {

inline constexpr std::size_t largest_parameter_count = 1'000;

struct Parameter {
    std::string name;
    double value = 0.0;  // low <= value <= high
    double usual = 0.0;  // as the experiment was written, before anything was set
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    std::string meaning;         // may be empty
    std::size_t line = 0;        // of the file
    mutable bool whole = false;  // some statement takes it for a whole number; told while the file is being read
};

// A value given for a parameter from outside, both as written.
struct Setting {
    std::string name;
    std::string value;
};

}  // namespace pelage
