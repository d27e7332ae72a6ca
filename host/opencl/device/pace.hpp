// Keeps the device busy without letting its queue grow without end.
#pragma once

#include "opencl/device/session.hpp"

#include <cstddef>

namespace pelage {

class Pace {
public:
    explicit Pace(const Session& session) : session_(session) {}

    // To be called after every launch: flushes now and then, and waits for old launches when many are under way.
    void launched();

private:
    static constexpr std::size_t flush_every = 8;
    static constexpr std::size_t wait_every = 32;

    const Session& session_;
    std::size_t launches_ = 0;
    cl::Event milestone_;  // at most 2 * wait_every launches are under way
};

}  // namespace pelage
