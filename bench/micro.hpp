// What the micro benchmarks share: one session, one device, and launches that are waited for.
#pragma once

#include "opencl/device/device.hpp"
#include "opencl/device/session.hpp"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace micro {

inline std::shared_ptr<const pelage::Session> session(pelage::Path path = pelage::Path::automatic) {
    pelage::OpenclOptions options;
    options.path = path;
    return std::make_shared<const pelage::Session>(pelage::select_device(), options);
}

// A buffer that holds `values`.
template <class T>
cl::Buffer filled(const pelage::Session& session, const std::vector<T>& values) {
    const std::size_t bytes = values.size() * sizeof(T);
    cl::Buffer buffer = session.buffer(bytes, "benchmark");
    session.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, values.data());
    return buffer;
}

inline cl_int as_int(std::int64_t value) { return static_cast<cl_int>(value); }

// Items of work a second, over all iterations of the benchmark.
inline void count_items(benchmark::State& state, double items_an_iteration) {
    state.SetItemsProcessed(static_cast<std::int64_t>(items_an_iteration * static_cast<double>(state.iterations())));
}

}  // namespace micro
