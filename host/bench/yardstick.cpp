// See yardstick.hpp.
#include "bench/yardstick.hpp"

#include "bench/aligned.hpp"
#include "bench/openmp.hpp"
#include "bench/openmp_rows.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/pace.hpp"
#include "opencl/device/program.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <limits>
#include <utility>

namespace pelage::bench {

namespace {

constexpr std::size_t device_items = 1u << 14;  // of the fma kernel
constexpr int device_rounds = 4096;
constexpr double device_flops_a_round = 2.0 * 8 * 16;  // eight float16 fma an item

class HostCopy final : public Task {
public:
    explicit HostCopy(std::size_t bytes) : from_(bytes / 4, 1.0f), to_(bytes / 4, 0.0f) {}
    void restart() override {}
    void work(std::uint64_t iterations) override {
        constexpr std::size_t part = 4096;
        const std::size_t parts = (from_.size() + part - 1) / part;
        for (std::uint64_t i = 0; i < iterations; ++i) {
#pragma omp parallel for schedule(static)
            for (std::size_t p = 0; p < parts; ++p) {
                copy_row(from_.data() + p * part, to_.data() + p * part, std::min(part, from_.size() - p * part));
            }
            std::swap(from_, to_);
        }
    }
    Outcome outcome() const override { return {}; }

private:
    Aligned<float> from_, to_;
};

cl::Kernel kernel(const Session& session, const char* name) {
    Source source;
    source.file("common/yardstick.cl");
    return cl::Kernel(session.build(source.str()), name);
}

class DeviceCopy final : public Task {
public:
    DeviceCopy(std::shared_ptr<const Session> session, std::size_t bytes)
        : session_(std::move(session)), items_(std::max<std::size_t>(1, bytes / 64)) {
        with_device(session_->info().name, [&] {
            kernel_ = kernel(*session_, "pelage_copy");
            from_ = session_->buffer(items_ * 64, "yardstick");
            to_ = session_->buffer(items_ * 64, "yardstick");
            session_->queue().enqueueFillBuffer(from_, cl_float{1}, 0, items_ * 64);
            session_->queue().enqueueFillBuffer(to_, cl_float{0}, 0, items_ * 64);
        });
    }
    void restart() override {}
    void work(std::uint64_t iterations) override {
        with_device(session_->info().name, [&] {
            Pace pace(*session_);
            for (std::uint64_t i = 0; i < iterations; ++i) {
                kernel_.setArg(0, from_);
                kernel_.setArg(1, to_);
                kernel_.setArg(2, static_cast<cl_uint>(items_));
                session_->queue().enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange((items_ + 63) / 64 * 64),
                                                       cl::NDRange(64));
                pace.launched();
                std::swap(from_, to_);
            }
            session_->queue().finish();
        });
    }
    Outcome outcome() const override { return {}; }

private:
    std::shared_ptr<const Session> session_;
    std::size_t items_;
    cl::Kernel kernel_;
    cl::Buffer from_, to_;
};

// The best of several runs: a yardstick is what is possible.
double best_seconds(const std::function<void()>& work, std::size_t runs) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t run = 0; run < runs + 1; ++run) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (run > 0) best = std::min(best, seconds);
    }
    return best;
}

std::size_t large_copy(double memory, bool quick) {
    const std::size_t wanted = quick ? 8u << 20 : 512u << 20;
    return std::min(wanted, static_cast<std::size_t>(memory / 16)) / 64 * 64;
}

double copy_bandwidth(Task& copy, std::size_t bytes, bool quick) {
    return 2 * static_cast<double>(bytes) / best_seconds([&] { copy.work(1); }, quick ? 2 : 7);
}

double host_peak(bool quick) {
    const std::size_t rounds = quick ? 20'000 : 1'000'000;
    volatile float sink = 0;
    const int threads = openmp_threads();
    const double seconds = best_seconds(
        [&] {
            float total = 0;
#pragma omp parallel for schedule(static) reduction(+ : total)
            for (int thread = 0; thread < threads; ++thread) total += fma_rounds(rounds);
            sink = sink + total;
        },
        quick ? 1 : 3);
    return fma_flops_a_round * static_cast<double>(rounds) * threads / seconds;
}

double device_peak(const Session& session, bool quick) {
    return with_device(session.info().name, [&] {
        cl::Kernel work = kernel(session, "pelage_multiply_add");
        const int rounds = quick ? device_rounds / 16 : device_rounds;
        const cl::Buffer sums = session.buffer(device_items * 4, "yardstick");
        work.setArg(0, sums);
        work.setArg(1, static_cast<cl_int>(rounds));
        const double seconds = best_seconds(
            [&] {
                session.queue().enqueueNDRangeKernel(work, cl::NullRange, cl::NDRange(device_items), cl::NDRange(64));
                session.queue().finish();
            },
            quick ? 1 : 3);
        return device_flops_a_round * rounds * static_cast<double>(device_items) / seconds;
    });
}

}  // namespace

std::unique_ptr<Task> host_copy(std::size_t bytes) { return std::make_unique<HostCopy>(bytes); }

std::unique_ptr<Task> device_copy(std::shared_ptr<const Session> session, std::size_t bytes) {
    return std::make_unique<DeviceCopy>(std::move(session), bytes);
}

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "cpu";
}

Yardstick measure_host(bool quick) {
    Yardstick found{processor_name(), __VERSION__, "C++", 0, 0, large_copy(8e9, quick), openmp_threads()};
    HostCopy copy(found.copy_bytes);
    found.copy_bandwidth = copy_bandwidth(copy, found.copy_bytes, quick);
    found.peak = host_peak(quick);
    return found;
}

Yardstick measure_device(std::shared_ptr<const Session> session, bool quick) {
    const DeviceInfo& info = session->info();
    Yardstick found{info.name, info.driver, info.platform, 0, 0, 0, static_cast<int>(info.compute_units)};
    const auto memory = static_cast<double>(std::min(info.memory, 4 * info.max_allocation));
    found.copy_bytes = large_copy(memory, quick);
    DeviceCopy copy(session, found.copy_bytes);
    found.copy_bandwidth = copy_bandwidth(copy, found.copy_bytes, quick);
    found.peak = device_peak(*session, quick);
    return found;
}

}  // namespace pelage::bench
