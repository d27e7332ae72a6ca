// Compares the backends of a case, then times them turn by turn.
#pragma once

#include "bench/cases.hpp"
#include "bench/options.hpp"
#include "bench/yardstick.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pelage::bench {

struct Result {
    std::string suite, name;
    std::size_t size = 0;
    std::string backend, device;
    std::size_t cells = 0;
    std::uint64_t iterations = 0;  // of one run
    double seconds = 0;            // of one run: the median
    double best = 0;               // the shortest
    double spread = 0;             // (longest - shortest) / median
    double updates_per_second = 0;
    double bytes_per_second = 0;  // that the algorithm must move once an iteration
    double copy_bandwidth = 0;    // of a copy of as many bytes as the fields hold, on the same device, in turn with it
    double bandwidth_share = 0;  // bytes_per_second / copy_bandwidth; above 1: faster than one pass an iteration can be
    double flops_per_update = 0, bytes_per_update = 0;
    double arithmetic_share = 0;    // of the measured peak
    double bytes_per_cell = 0;      // held by the task; 0: not known
    double largest_difference = 0;  // from the expected result; 0 where equality of bits was demanded and found
};

struct Note {  // why something is not among the results
    std::string suite, name;
    std::size_t size = 0;
    std::string backend, device;
    std::string text;
    bool wrong = false;  // it was compared and found different
};

struct Report {
    std::vector<Yardstick> yardsticks;  // the host first
    std::vector<Result> results;
    std::vector<Note> notes;
    double load = 0;  // processes that wanted a processor before the measurement began, as the system averages them
};

// Called with a line of progress now and then.
using Say = std::function<void(const std::string&)>;

// Called with all that is known so far, whenever a case of one size has been measured.
using Keep = std::function<void(const Report&)>;

// Throws Error when the options are wrong or no device is there.
Report measure(const Options&, const Say&, const Keep&);

}  // namespace pelage::bench
