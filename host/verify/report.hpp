// What became of checks, to be printed, kept and compared between devices.
#pragma once

#include "opencl/device/device.hpp"
#include "verify/check.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pelage::verify {

struct Result {
    std::string name;
    std::string kernel;
    Verdict verdict = Verdict::passed;
    std::string message;
    bool broken_off = false;  // see Outcome
    std::string first;        // the first cell that differs, with both values
    std::uint64_t cells_compared = 0;
    std::uint64_t cells_differing = 0;
    std::uint64_t max_ulp = 0;
    double max_absolute = 0.0;
    double max_relative = 0.0;
    std::string fingerprint;  // of all that the device gave: devices with the same one gave the same bits
    double seconds = 0.0;
    std::vector<std::filesystem::path> files;  // evidence: pictures of reference, device and difference
};

struct DeviceReport {
    DeviceInfo device;
    std::string build_options;
    std::vector<Result> results;
};

struct Report {
    std::string version;
    std::string date;  // when it began, as 2026-01-31T12:00:00Z
    std::uint64_t seed = 1;
    std::string form;          // "quick" or "full"
    std::string kernels;       // folder of other kernels than the program's own; empty: those
    std::string schedule;      // order of work that was provoked; empty: the device's own
    std::size_t left_out = 0;  // checks that a signal left undone
    double seconds = 0.0;
    std::vector<DeviceReport> devices;
};

// All results of one kernel, or of everything, together.
struct Summary {
    std::string kernel;
    std::size_t cases = 0;
    std::size_t passed = 0;
    std::size_t failed = 0;
    std::size_t mistrusted = 0;
    std::size_t skipped = 0;
    std::uint64_t cells_compared = 0;
    std::uint64_t cells_differing = 0;
    std::uint64_t max_ulp = 0;
    double max_absolute = 0.0;
    double max_relative = 0.0;

    void add(const Result&);
    Verdict verdict() const;  // failed before mistrusted before passed; skipped only where nothing else was
};

std::vector<Summary> by_kernel(const std::vector<Result>&);  // in order of first appearance
Summary total(const std::vector<Result>&);
Summary total(const Report&);

// "stopped" where checks were left out; else the verdict on all.
const char* verdict_word(const Report&);

// What else a reader must know: other kernels than the program's own, an order of work that was provoked, checks that
// were left out. One sentence each, without a full stop.
std::vector<std::string> conditions(const Report&);

// One line for each check that two devices ran with unlike results.
std::vector<std::string> unlike(const Report&);

// Runs a check, measures it, and keeps evidence of a difference as EXR and PNG in `evidence` (made when needed; none
// when empty).
Result judge(const Check&, Place&, const std::filesystem::path& evidence);

nlohmann::ordered_json to_json(const Result&);
Result result_from_json(const nlohmann::ordered_json&);  // throws nlohmann::json::exception
nlohmann::ordered_json to_json(const Report&);

// "1,024", "1.8e+19"; "no number" where a NaN stands against a number, which no count of steps between them tells.
std::string ulp_text(std::uint64_t ulps);

// The table of verdicts by kernel, in lines of text.
std::string table(const std::vector<Result>&);

// One self-contained page: devices, verdicts, cases, and pictures of differences.
std::string html(const Report&);

}  // namespace pelage::verify
