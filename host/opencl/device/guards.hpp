// Guard zones around buffers, for runs that look for stray writes: slow, see OpenclOptions::guarded.
#pragma once

#include "opencl/device/cl.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace pelage {

// 32 bits that are a NaN as a float and, twice, as a double, and a large number as an integer: what is read before it
// was written shows in the result.
inline constexpr cl_uint poison = 0x7ffdcba9u;

class Guards {
public:
    Guards(cl::Context, cl::CommandQueue, const cl::Device&);

    // A buffer of poison between two zones of it.
    cl::Buffer allocate(std::size_t bytes, const std::string& what, cl_mem_flags);

    // Waits for the device and looks at every zone. Throws Error, naming `kernel` and the buffer, when one was written.
    void check(const std::string& kernel);

private:
    struct Zone {
        cl::Buffer whole;
        cl::Buffer inner;
        std::size_t bytes = 0;
        std::string what;
    };

    void look(std::span<const cl_uint> found, bool after, const Zone&, const std::string& kernel) const;
    void forget_released();

    cl::Context context_;
    cl::CommandQueue queue_;
    std::size_t guard_;  // bytes of a zone
    std::vector<Zone> zones_;
};

}  // namespace pelage
