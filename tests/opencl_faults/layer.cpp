// Every OpenCL function that the program calls, in place of the library's: each asks the layer first.
#include "faults.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

using test::behind;
using test::Faults;
using test::Machine;

namespace {

Faults& faults() { return Faults::layer(); }

// A call that returns a status and owns nothing.
template <class Function, class... Arguments>
cl_int plain(const char* name, Arguments... arguments) {
    if (const cl_int code = faults().enter(name); code != CL_SUCCESS) return code;
    return behind<Function>(name)(arguments...);
}

// A call that makes an object and hands its status to the last parameter.
template <class Function, class... Arguments>
auto making(const char* name, const char* kind, cl_int* status, Arguments... arguments) {
    using Handle = decltype(behind<Function>(name)(arguments..., status));
    cl_int code = faults().enter(name);
    Handle made = nullptr;
    if (code == CL_SUCCESS) made = behind<Function>(name)(arguments..., &code);
    if (code == CL_SUCCESS) faults().created(kind, made);
    if (status != nullptr) *status = code;
    return made;
}

template <class Function, class Handle>
cl_int retaining(const char* name, const char* kind, Handle object) {
    const cl_int code = plain<Function>(name, object);
    if (code == CL_SUCCESS) faults().retained(kind, object);
    return code;
}

template <class Function, class Handle>
cl_int releasing(const char* name, const char* kind, Handle object) {
    if (const cl_int code = faults().enter(name); code != CL_SUCCESS) {
        faults().not_released(object);
        return code;
    }
    faults().released(kind, object);
    return behind<Function>(name)(object);
}

// An enqueued command that may hand out an event.
template <class Function, class... Arguments>
cl_int enqueuing(const char* name, cl_event* event, Arguments... arguments) {
    const cl_int code = plain<Function>(name, arguments..., event);
    if (code == CL_SUCCESS && event != nullptr) faults().created("event", *event);
    return code;
}

// An answer of clGet...Info.
cl_int answer(const std::string& bytes, size_t size, void* value, size_t* needed) {
    if (needed != nullptr) *needed = bytes.size();
    if (value == nullptr) return CL_SUCCESS;
    if (size < bytes.size()) return CL_INVALID_VALUE;
    std::memcpy(value, bytes.data(), bytes.size());
    return CL_SUCCESS;
}

std::array<char, 2> pretended{};  // their addresses stand for the platforms that are empty and broken

cl_platform_id pretended_platform(std::size_t which) { return reinterpret_cast<cl_platform_id>(&pretended[which]); }

bool has_cpu(cl_platform_id platform) {
    cl_uint count = 0;
    return behind<decltype(clGetDeviceIDs)>("clGetDeviceIDs")(platform, CL_DEVICE_TYPE_CPU, 0, nullptr, &count) ==
               CL_SUCCESS &&
           count > 0;
}

// The library's first platform with a CPU, else its first.
cl_platform_id real_platform() {
    static const cl_platform_id chosen = [] {
        cl_uint count = 0;
        const auto get = behind<decltype(clGetPlatformIDs)>("clGetPlatformIDs");
        get(0, nullptr, &count);
        std::vector<cl_platform_id> all(count);
        get(count, all.data(), nullptr);
        const auto found = std::find_if(all.begin(), all.end(), has_cpu);
        return found != all.end() ? *found : all.empty() ? nullptr : all.front();
    }();
    return chosen;
}

cl_platform_id platform_of(Machine::Platform kind) {
    if (kind == Machine::Platform::real) return real_platform();
    return pretended_platform(kind == Machine::Platform::empty ? 0 : 1);
}

size_t product(cl_uint dimensions, const size_t* sizes) {
    size_t all = 1;
    for (cl_uint i = 0; i < dimensions; ++i) all *= sizes[i];
    return all;
}

}  // namespace

extern "C" {

cl_int clGetPlatformIDs(cl_uint room, cl_platform_id* platforms, cl_uint* count) {
    if (const cl_int code = faults().enter("clGetPlatformIDs"); code != CL_SUCCESS) return code;
    const auto& kinds = faults().machine.platforms;
    if (count != nullptr) *count = static_cast<cl_uint>(kinds.size());
    if (kinds.empty()) return -1001;
    for (std::size_t i = 0; platforms != nullptr && i < std::min<std::size_t>(room, kinds.size()); ++i) {
        platforms[i] = platform_of(kinds[i]);
    }
    return CL_SUCCESS;
}

cl_int clGetPlatformInfo(cl_platform_id platform, cl_platform_info what, size_t size, void* value, size_t* needed) {
    for (const std::size_t which : {0u, 1u}) {
        if (platform != pretended_platform(which)) continue;
        if (const cl_int code = faults().enter("clGetPlatformInfo"); code != CL_SUCCESS) return code;
        const std::string text = what == CL_PLATFORM_VERSION ? "OpenCL 1.2" : which == 0 ? "Empty" : "Broken";
        return answer(text + '\0', size, value, needed);
    }
    return plain<decltype(clGetPlatformInfo)>("clGetPlatformInfo", platform, what, size, value, needed);
}

cl_int clGetDeviceIDs(cl_platform_id platform, cl_device_type type, cl_uint room, cl_device_id* devices,
                      cl_uint* count) {
    for (const std::size_t which : {0u, 1u}) {
        if (platform != pretended_platform(which)) continue;
        if (const cl_int code = faults().enter("clGetDeviceIDs"); code != CL_SUCCESS) return code;
        return which == 0 ? CL_DEVICE_NOT_FOUND : CL_OUT_OF_HOST_MEMORY;
    }
    return plain<decltype(clGetDeviceIDs)>("clGetDeviceIDs", platform, type, room, devices, count);
}

cl_int clGetDeviceInfo(cl_device_id device, cl_device_info what, size_t size, void* value, size_t* needed) {
    const auto& answers = faults().machine.answers;
    const auto found = answers.find(what);
    if (found == answers.end()) {
        return plain<decltype(clGetDeviceInfo)>("clGetDeviceInfo", device, what, size, value, needed);
    }
    if (const cl_int code = faults().enter("clGetDeviceInfo"); code != CL_SUCCESS) return code;
    return found->second.empty() ? CL_INVALID_VALUE : answer(found->second, size, value, needed);
}

cl_int clRetainDevice(cl_device_id device) {
    return retaining<decltype(clRetainDevice)>("clRetainDevice", "device", device);
}

cl_int clReleaseDevice(cl_device_id device) {
    return releasing<decltype(clReleaseDevice)>("clReleaseDevice", "device", device);
}

cl_context clCreateContext(const cl_context_properties* properties, cl_uint count, const cl_device_id* devices,
                           void(CL_CALLBACK* notify)(const char*, const void*, size_t, void*), void* user,
                           cl_int* status) {
    return making<decltype(clCreateContext)>("clCreateContext", "context", status, properties, count, devices, notify,
                                             user);
}

cl_int clRetainContext(cl_context context) {
    return retaining<decltype(clRetainContext)>("clRetainContext", "context", context);
}

cl_int clReleaseContext(cl_context context) {
    return releasing<decltype(clReleaseContext)>("clReleaseContext", "context", context);
}

cl_command_queue clCreateCommandQueue(cl_context context, cl_device_id device, cl_command_queue_properties properties,
                                      cl_int* status) {
    return making<decltype(clCreateCommandQueue)>("clCreateCommandQueue", "queue", status, context, device, properties);
}

cl_int clRetainCommandQueue(cl_command_queue queue) {
    return retaining<decltype(clRetainCommandQueue)>("clRetainCommandQueue", "queue", queue);
}

cl_int clReleaseCommandQueue(cl_command_queue queue) {
    return releasing<decltype(clReleaseCommandQueue)>("clReleaseCommandQueue", "queue", queue);
}

cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, size_t size, void* host, cl_int* status) {
    cl_int code = faults().enter("clCreateBuffer");
    if (code == CL_SUCCESS) code = faults().refuse_buffer(size);
    cl_mem made = nullptr;
    if (code == CL_SUCCESS)
        made = behind<decltype(clCreateBuffer)>("clCreateBuffer")(context, flags, size, host, &code);
    if (code == CL_SUCCESS) faults().created("buffer", made, size);
    if (status != nullptr) *status = code;
    return made;
}

cl_mem clCreateSubBuffer(cl_mem buffer, cl_mem_flags flags, cl_buffer_create_type type, const void* region,
                         cl_int* status) {
    return making<decltype(clCreateSubBuffer)>("clCreateSubBuffer", "buffer", status, buffer, flags, type, region);
}

cl_int clGetMemObjectInfo(cl_mem buffer, cl_mem_info what, size_t size, void* value, size_t* needed) {
    return plain<decltype(clGetMemObjectInfo)>("clGetMemObjectInfo", buffer, what, size, value, needed);
}

cl_int clRetainMemObject(cl_mem buffer) {
    return retaining<decltype(clRetainMemObject)>("clRetainMemObject", "buffer", buffer);
}

cl_int clReleaseMemObject(cl_mem buffer) {
    return releasing<decltype(clReleaseMemObject)>("clReleaseMemObject", "buffer", buffer);
}

cl_program clCreateProgramWithSource(cl_context context, cl_uint count, const char** texts, const size_t* lengths,
                                     cl_int* status) {
    if (!faults().machine.no_double) {
        return making<decltype(clCreateProgramWithSource)>("clCreateProgramWithSource", "program", status, context,
                                                           count, texts, lengths);
    }
    std::string text = "#define double this_device_has_no_double\n";
    for (cl_uint i = 0; i < count; ++i) {
        const bool whole = lengths == nullptr || lengths[i] == 0;
        text += whole ? std::string(texts[i]) : std::string(texts[i], lengths[i]);
    }
    const char* pointer = text.c_str();
    const char** only = &pointer;
    const size_t* to_its_end = nullptr;
    return making<decltype(clCreateProgramWithSource)>("clCreateProgramWithSource", "program", status, context,
                                                       cl_uint{1}, only, to_its_end);
}

cl_program clCreateProgramWithBinary(cl_context context, cl_uint count, const cl_device_id* devices,
                                     const size_t* lengths, const unsigned char** binaries, cl_int* each,
                                     cl_int* status) {
    if (faults().machine.binaries) {
        return making<decltype(clCreateProgramWithBinary)>("clCreateProgramWithBinary", "program", status, context,
                                                           count, devices, lengths, binaries, each);
    }
    faults().enter("clCreateProgramWithBinary");
    if (status != nullptr) *status = CL_INVALID_BINARY;
    return nullptr;
}

cl_int clRetainProgram(cl_program program) {
    return retaining<decltype(clRetainProgram)>("clRetainProgram", "program", program);
}

cl_int clReleaseProgram(cl_program program) {
    return releasing<decltype(clReleaseProgram)>("clReleaseProgram", "program", program);
}

cl_int clBuildProgram(cl_program program, cl_uint count, const cl_device_id* devices, const char* options,
                      void(CL_CALLBACK* notify)(cl_program, void*), void* user) {
    return plain<decltype(clBuildProgram)>("clBuildProgram", program, count, devices, options, notify, user);
}

cl_int clGetProgramInfo(cl_program program, cl_program_info what, size_t size, void* value, size_t* needed) {
    return plain<decltype(clGetProgramInfo)>("clGetProgramInfo", program, what, size, value, needed);
}

cl_int clGetProgramBuildInfo(cl_program program, cl_device_id device, cl_program_build_info what, size_t size,
                             void* value, size_t* needed) {
    return plain<decltype(clGetProgramBuildInfo)>("clGetProgramBuildInfo", program, device, what, size, value, needed);
}

cl_kernel clCreateKernel(cl_program program, const char* kernel, cl_int* status) {
    return making<decltype(clCreateKernel)>("clCreateKernel", "kernel", status, program, kernel);
}

cl_int clGetKernelInfo(cl_kernel kernel, cl_kernel_info what, size_t size, void* value, size_t* needed) {
    return plain<decltype(clGetKernelInfo)>("clGetKernelInfo", kernel, what, size, value, needed);
}

cl_int clGetKernelWorkGroupInfo(cl_kernel kernel, cl_device_id device, cl_kernel_work_group_info what, size_t size,
                                void* value, size_t* needed) {
    return plain<decltype(clGetKernelWorkGroupInfo)>("clGetKernelWorkGroupInfo", kernel, device, what, size, value,
                                                     needed);
}

cl_int clSetKernelArg(cl_kernel kernel, cl_uint index, size_t size, const void* value) {
    return plain<decltype(clSetKernelArg)>("clSetKernelArg", kernel, index, size, value);
}

cl_int clRetainKernel(cl_kernel kernel) {
    return retaining<decltype(clRetainKernel)>("clRetainKernel", "kernel", kernel);
}

cl_int clReleaseKernel(cl_kernel kernel) {
    return releasing<decltype(clReleaseKernel)>("clReleaseKernel", "kernel", kernel);
}

cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions, const size_t* offset,
                              const size_t* global, const size_t* local, cl_uint waits, const cl_event* wait,
                              cl_event* event) {
    const std::size_t limit = faults().machine.work_group;
    if (limit != 0 && local != nullptr && product(dimensions, local) > limit) {
        faults().enter("clEnqueueNDRangeKernel");
        return CL_INVALID_WORK_GROUP_SIZE;
    }
    return enqueuing<decltype(clEnqueueNDRangeKernel)>("clEnqueueNDRangeKernel", event, queue, kernel, dimensions,
                                                       offset, global, local, waits, wait);
}

cl_int clEnqueueReadBufferRect(cl_command_queue queue, cl_mem buffer, cl_bool blocking, const size_t* from,
                               const size_t* to, const size_t* region, size_t from_row, size_t from_slice,
                               size_t to_row, size_t to_slice, void* memory, cl_uint waits, const cl_event* list,
                               cl_event* event) {
    return enqueuing<decltype(clEnqueueReadBufferRect)>("clEnqueueReadBufferRect", event, queue, buffer, blocking, from,
                                                        to, region, from_row, from_slice, to_row, to_slice, memory,
                                                        waits, list);
}

cl_int clEnqueueReadBuffer(cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset, size_t size,
                           void* to, cl_uint waits, const cl_event* wait, cl_event* event) {
    return enqueuing<decltype(clEnqueueReadBuffer)>("clEnqueueReadBuffer", event, queue, buffer, blocking, offset, size,
                                                    to, waits, wait);
}

cl_int clEnqueueWriteBuffer(cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset, size_t size,
                            const void* from, cl_uint waits, const cl_event* wait, cl_event* event) {
    return enqueuing<decltype(clEnqueueWriteBuffer)>("clEnqueueWriteBuffer", event, queue, buffer, blocking, offset,
                                                     size, from, waits, wait);
}

cl_int clEnqueueFillBuffer(cl_command_queue queue, cl_mem buffer, const void* pattern, size_t pattern_size,
                           size_t offset, size_t size, cl_uint waits, const cl_event* wait, cl_event* event) {
    return enqueuing<decltype(clEnqueueFillBuffer)>("clEnqueueFillBuffer", event, queue, buffer, pattern, pattern_size,
                                                    offset, size, waits, wait);
}

cl_int clEnqueueCopyBuffer(cl_command_queue queue, cl_mem from, cl_mem to, size_t from_offset, size_t to_offset,
                           size_t size, cl_uint waits, const cl_event* wait, cl_event* event) {
    return enqueuing<decltype(clEnqueueCopyBuffer)>("clEnqueueCopyBuffer", event, queue, from, to, from_offset,
                                                    to_offset, size, waits, wait);
}

cl_int clEnqueueMarkerWithWaitList(cl_command_queue queue, cl_uint waits, const cl_event* wait, cl_event* event) {
    return enqueuing<decltype(clEnqueueMarkerWithWaitList)>("clEnqueueMarkerWithWaitList", event, queue, waits, wait);
}

cl_int clWaitForEvents(cl_uint count, const cl_event* events) {
    return plain<decltype(clWaitForEvents)>("clWaitForEvents", count, events);
}

cl_int clRetainEvent(cl_event event) { return retaining<decltype(clRetainEvent)>("clRetainEvent", "event", event); }

cl_int clReleaseEvent(cl_event event) { return releasing<decltype(clReleaseEvent)>("clReleaseEvent", "event", event); }

cl_int clFlush(cl_command_queue queue) { return plain<decltype(clFlush)>("clFlush", queue); }

cl_int clFinish(cl_command_queue queue) { return plain<decltype(clFinish)>("clFinish", queue); }

}  // extern "C"
