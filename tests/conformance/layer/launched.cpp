// Preloaded before the OpenCL library: adds the name of each kernel that is launched to the file that PELAGE_LAUNCHED
// names, once a process.
#include <CL/cl.h>
#include <dlfcn.h>

#include <cstdlib>
#include <fstream>
#include <mutex>
#include <set>
#include <string>

namespace {

void note(cl_kernel kernel) {
    const char* const file = std::getenv("PELAGE_LAUNCHED");
    if (file == nullptr) return;
    char name[256] = {};
    if (clGetKernelInfo(kernel, CL_KERNEL_FUNCTION_NAME, sizeof name, name, nullptr) != CL_SUCCESS) return;
    static std::mutex guard;
    static std::set<std::string>& known = *new std::set<std::string>;
    const std::lock_guard lock(guard);
    if (!known.insert(name).second) return;
    std::ofstream(file, std::ios::app) << std::string(name) + "\n";
}

}  // namespace

extern "C" cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                                         const size_t* offset, const size_t* global, const size_t* local, cl_uint waits,
                                         const cl_event* wait_for, cl_event* event) {
    static auto* const launch =
        reinterpret_cast<decltype(clEnqueueNDRangeKernel)*>(dlsym(RTLD_NEXT, "clEnqueueNDRangeKernel"));
    note(kernel);
    return launch(queue, kernel, dimensions, offset, global, local, waits, wait_for, event);
}
