// See room.hpp.
#include "opencl/device/room.hpp"

#include "core/allowance.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <cstdlib>

namespace pelage {

namespace {

// Measured with PoCL 3.1 and LLVM 14, Mesa's drivers beside it, as the address space that `pelage run` takes for 64
// cells: 400 MiB and 27 for each of PoCL's threads.
constexpr double mebibyte = 1 << 20;
constexpr double drivers = 440 * mebibyte;
constexpr double a_thread = 28 * mebibyte;

double threads() {
    const char* set = std::getenv("POCL_MAX_PTHREAD_COUNT");
    const double asked = set == nullptr ? 0 : std::atof(set);
    return asked > 0 ? asked : static_cast<double>(usable_processors());
}

}  // namespace

std::string why_no_room() {
    const auto limit = process_limit();
    const double needed = drivers + threads() * a_thread;
    if (!limit || limit->left() >= needed) return {};
    return fmt::format(
        "drivers need about {:.0f} MiB of memory to load and to compile, and {:.0f} MiB may be used ({})",
        needed / mebibyte, limit->left() / mebibyte, limit->option);
}

void be_sparing() { mallopt(M_ARENA_MAX, 1); }

}  // namespace pelage
