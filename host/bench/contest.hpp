// Who takes part in a case of one size: all backends that are wanted and have an answer, and why others have none.
#pragma once

#include "bench/cases.hpp"
#include "bench/measure.hpp"
#include "bench/task.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pelage::bench {

// One device, in four ways.
struct DeviceSessions {
    std::shared_ptr<const Session> plain;     // one cell a work-item, one iteration a launch: as one writes it first
    std::shared_ptr<const Session> step;      // our best kernel of one iteration a launch
    std::shared_ptr<const Session> standard;  // as `pelage run` would
    std::shared_ptr<const Session> fast;      // the same with equality given up
};

// Those that --device names; the usual one when it names none. Throws Error when there is none.
std::vector<DeviceSessions> open_devices(const std::string& wanted);

struct Contest {
    std::vector<Contender> contenders;  // the first one's result is the expected one
    std::vector<Contender> probes;      // a copy of as many bytes, one a device, the host's among them
    std::vector<Note> absent;
    Outcome initial;            // empty: none to move away from
    std::uint64_t stretch = 0;  // iterations that are compared
    std::uint64_t whole = 0;    // of a run that starts anew; 0: runs go on where the last one ended
    double updates = 0;         // of cells, in one iteration, or in the whole run
    std::size_t cells = 0;
};

Contest make_contest(const Options&, const Case&, std::size_t size, const std::vector<DeviceSessions>&);

}  // namespace pelage::bench
