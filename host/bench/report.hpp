// What was measured, as text and as JSON.
#pragma once

#include "bench/measure.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace pelage::bench {

// How many times faster `backend` is than `against`, same case, size and (unless one of them is the host) device.
struct Ratio {
    std::string suite, name;
    std::size_t size = 0;
    std::string backend, against, device;
    double ratio = 0;  // of the shortest runs: the least disturbed ones
};

// opencl against every other backend, and against one pass over memory an iteration ("copy").
std::vector<Ratio> ratios(const Report&);

std::string tables(const Report&);  // yardsticks, results, ratios, notes

// complete: false while more is to be measured.
nlohmann::ordered_json json_of(const Report&, const Options&, bool complete);

}  // namespace pelage::bench
