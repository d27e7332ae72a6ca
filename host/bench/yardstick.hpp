// What a machine can do at most, measured: bytes copied and fma carried out a second.
#pragma once

#include "bench/task.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace pelage::bench {

// One iteration copies `bytes` from one buffer to another, and moves 2 * bytes. Every second one goes back.
std::unique_ptr<Task> host_copy(std::size_t bytes);
std::unique_ptr<Task> device_copy(std::shared_ptr<const Session>, std::size_t bytes);

struct Yardstick {
    std::string device;
    std::string driver;          // the compiler's version for the host
    std::string platform;        // "C++" for the host
    double copy_bandwidth = 0;   // bytes a second, read and written, of arrays far larger than caches
    double peak = 0;             // floating-point operations a second, fma counted as two, single precision
    std::size_t copy_bytes = 0;  // size of the array that was copied
    int threads = 1;             // of the host, or compute units
};

Yardstick measure_host(bool quick);
Yardstick measure_device(std::shared_ptr<const Session>, bool quick);

std::string processor_name();

}  // namespace pelage::bench
