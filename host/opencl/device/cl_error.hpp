// OpenCL failures in words: which call, which error, on which device.
#pragma once

#include "core/error.hpp"
#include "opencl/device/cl.hpp"

#include <string>
#include <utility>

namespace pelage {

// "CL_OUT_OF_RESOURCES"; "error -1234" for a code the standard does not name.
std::string cl_error_name(cl_int code);

// "OpenCL call clEnqueueNDRangeKernel failed with CL_OUT_OF_RESOURCES (-5) on device 'NAME'".
Error cl_failure(const cl::Error&, const std::string& device);

// Carries out `work`; a cl::Error that leaves it becomes an Error naming the device.
template <class Work>
decltype(auto) with_device(const std::string& device, Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const cl::Error& error) {
        throw cl_failure(error, device);
    }
}

}  // namespace pelage
