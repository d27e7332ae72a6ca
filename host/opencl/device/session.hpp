// One device made ready for work: context, queue, and how programs are built for it.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/cl.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/guards.hpp"
#include "opencl/device/options.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace pelage {

class Session {
public:
    Session(DeviceInfo info, OpenclOptions options);
    ~Session();  // waits for all launches
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    const DeviceInfo& info() const { return info_; }
    const OpenclOptions& options() const { return options_; }
    const cl::Device& device() const { return device_; }
    const cl::Context& context() const { return *context_; }
    const cl::CommandQueue& queue() const { return queue_; }  // in order

    bool is_double() const { return options_.precision == Precision::double_; }
    std::size_t scalar_bytes() const { return is_double() ? 8 : 4; }

    // Options that every program of this session is built with.
    std::string build_options() const;

    // Builds with build_options() and `more`, from the cache when it can; what this session has built before is handed
    // out again. Throws Error when the build fails; see program.hpp.
    cl::Program build(const std::string& source, const std::string& more = "") const;
    std::size_t programs() const;  // built so far, all different
    ProgramCounts program_counts() const;

    // Throws Error when one buffer of that many bytes cannot be had on the device. `what` names its contents.
    cl::Buffer buffer(std::size_t bytes, const std::string& what, cl_mem_flags flags = CL_MEM_READ_WRITE) const;

    // Every launch goes through here. Guarded sessions wait for it and throw Error when a buffer's guard was written.
    void launch(const cl::Kernel&, const cl::NDRange& global, const cl::NDRange& local) const;

    // Guarded sessions fill with poison what a launch must write: what it leaves out then shows.
    void poison_buffer(const cl::Buffer&, std::size_t bytes) const;
    bool guarded() const { return guards_ != nullptr; }

private:
    DeviceInfo info_;
    OpenclOptions options_;
    cl::Device device_;
    std::shared_ptr<const cl::Context> context_;  // of all sessions on this device
    cl::CommandQueue queue_;
    std::unique_ptr<Guards> guards_;  // none: not guarded
    mutable std::mutex building_;
    mutable std::map<std::string, cl::Program> programs_;  // by options and source
    mutable ProgramCounts counts_;                         // of them
};

}  // namespace pelage
