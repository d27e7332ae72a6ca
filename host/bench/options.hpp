// What `pelage bench` is asked to measure.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pelage::bench {

struct Options {
    std::string suite = "all";         // lattice, cells, neighbours, growth or all
    std::string device;                // index or name, or "all"; empty: the one that `pelage run` would take
    std::vector<std::string> against;  // backends beside opencl; empty: all that a case has
    std::vector<std::size_t> sizes;    // sides of lattices, numbers of free cells and points; empty: each case's own
    std::vector<std::string> cases;    // names; empty: each suite's own choice, "all": every one
    std::size_t runs = 5;              // of each backend, interleaved
    bool quick = false;                // small sizes and short runs: to see that all works

    bool wants(const std::string& backend) const;  // by `against`
    double seconds_a_run() const { return quick ? 0.02 : 0.25; }
};

const std::vector<std::string>& suites();
const std::vector<std::string>& backends();

// Throws Error naming what is allowed when a word is unknown or a size is 0 or absurd.
void check(const Options&);

}  // namespace pelage::bench
