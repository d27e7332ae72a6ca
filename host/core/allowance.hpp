// What this process may use of the machine: control groups, affinity and limits may leave less than there is.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace pelage {

// The least of the limits that the control groups of this process set, at every level of both versions; nothing where
// none is set. `root` is where /proc and /sys are found.
std::optional<double> group_memory(const std::filesystem::path& root = "/");      // bytes
std::optional<double> group_processors(const std::filesystem::path& root = "/");  // processor time a second

// What a limit on a process's own size allows: on its address space (ulimit -v) or on its data (ulimit -d).
struct ProcessLimit {
    double bytes = 0;
    double taken = 0;         // of them, by now
    const char* option = "";  // "ulimit -v"

    double left() const { return bytes - taken; }
};

// The tighter of the two; nothing where neither is set.
std::optional<ProcessLimit> process_limit();

// Bytes that this process may take beside those that it has: of physical memory, or less where a control group or a
// limit on the process says so.
double usable_memory();

// How many threads of this process can run at once; at least 1. Asked for once and remembered.
std::size_t usable_processors();

// Whether this process may run on each of the processors 0 .. count - 1.
bool may_run_on_first(std::size_t count);

}  // namespace pelage
