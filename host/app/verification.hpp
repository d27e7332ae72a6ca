// Checks dealt out to child processes, so that a device that crashes or hangs fails one check and not all.
#pragma once

#include "verify/report.hpp"
#include "verify/seed.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pelage::app {

struct VerifyOptions {
    std::string command = "pelage";  // as the user called it
    std::string device;              // index, name, type or "all"; empty: the one that a run would take
    bool full = false;
    bool small = false;
    std::string filter;  // part of the names of checks; empty: all
    std::uint64_t seed = verify::usual_seed;
    std::size_t jobs = 0;     // child processes; 0: as many as processors, at most 8
    std::size_t limit = 300;  // seconds a check may take
    std::filesystem::path evidence = "pelage-verify";
    bool quiet = false;
};

// The checks that the options select. Throws Error when there are none.
std::vector<verify::Check> selected(const VerifyOptions&);

// All selected checks on one device, in their order.
verify::DeviceReport verify_device(const DeviceInfo&, const std::vector<verify::Check>&, const VerifyOptions&);

// In a child process: reads names of checks and answers each with its result, until the end of its input.
int answer_checks(const VerifyOptions&);

// The command that runs one check alone, quoted for a POSIX shell.
std::string reproduce_command(const VerifyOptions&, const DeviceInfo&, const std::string& check);

}  // namespace pelage::app
