// A guard against slow changes: ratios that once were reached, and how much of them may be lost. Never seconds: those
// belong to one machine.
#pragma once

#include "bench/report.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pelage::bench {

struct Demand {
    std::string suite, name;
    std::size_t size = 0;
    std::string against;               // opencl is held against this backend
    double ratio = 0;                  // reached when the table was written
    std::optional<double> slack = {};  // instead of the guard's
};

struct Guard {
    double slack = 0.5;  // the share of a ratio that must still be there
    std::vector<Demand> demands;
};

// {"slack": S, "ratios": [{"suite", "case", "size", "against", "ratio"}, ...]}, "slack" in a ratio too where it is its
// own. Throws Error naming the file and what is wrong there.
Guard read_guard(const std::filesystem::path&);

// Only what the guard asks about.
std::vector<Options> options_for(const Guard&, const Options&);

struct Verdict {
    std::string text;  // a line for each demand
    bool kept = true;  // all of them
};

Verdict judge(const Guard&, const std::vector<Ratio>&);

}  // namespace pelage::bench
