// Preloaded before the OpenCL library when Oclgrind 21.10 looks for values that were never initialised. Its record of
// what is initialised goes wrong in four ways, each of which makes it report values that were written:
//   - clEnqueueFillBuffer counts for nothing,
//   - a write of a part of a buffer, or a copy into it, wipes out what is known of the rest,
//   - a buffer that takes the place of a smaller one that was released is known as far as the smaller one went,
//   - a write to a sub-buffer counts for another place (verification makes none there).
// So every change by the host becomes a write of the whole buffer, and no buffer is released. What this hides: a part
// that nobody wrote, of a buffer of which the host wrote another part.
#include <CL/cl.h>
#include <dlfcn.h>

#include <cstring>
#include <vector>

namespace {

template <class Function>
Function* behind(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

std::size_t size_of(cl_mem buffer) {
    std::size_t size = 0;
    clGetMemObjectInfo(buffer, CL_MEM_SIZE, sizeof size, &size, nullptr);
    return size;
}

std::vector<char> contents(cl_command_queue queue, cl_mem buffer) {
    std::vector<char> bytes(size_of(buffer));
    clEnqueueReadBuffer(queue, buffer, CL_TRUE, 0, bytes.size(), bytes.data(), 0, nullptr, nullptr);
    return bytes;
}

}  // namespace

extern "C" {

cl_int clEnqueueWriteBuffer(cl_command_queue queue, cl_mem buffer, cl_bool, size_t offset, size_t size,
                            const void* from, cl_uint waits, const cl_event* wait_for, cl_event* event) {
    static auto* const write = behind<decltype(clEnqueueWriteBuffer)>("clEnqueueWriteBuffer");
    const std::size_t whole = size_of(buffer);
    if (offset + size > whole || size == whole) {
        return write(queue, buffer, CL_TRUE, offset, size, from, waits, wait_for, event);
    }
    std::vector<char> bytes = contents(queue, buffer);
    std::memcpy(bytes.data() + offset, from, size);
    return write(queue, buffer, CL_TRUE, 0, whole, bytes.data(), waits, wait_for, event);
}

cl_int clEnqueueFillBuffer(cl_command_queue queue, cl_mem buffer, const void* pattern, size_t pattern_size,
                           size_t offset, size_t size, cl_uint waits, const cl_event* wait_for, cl_event* event) {
    std::vector<char> bytes(size);
    for (std::size_t i = 0; i < size; i += pattern_size) std::memcpy(bytes.data() + i, pattern, pattern_size);
    return clEnqueueWriteBuffer(queue, buffer, CL_TRUE, offset, size, bytes.data(), waits, wait_for, event);
}

cl_int clEnqueueCopyBuffer(cl_command_queue queue, cl_mem from, cl_mem to, size_t from_offset, size_t to_offset,
                           size_t size, cl_uint waits, const cl_event* wait_for, cl_event* event) {
    const std::vector<char> bytes = contents(queue, from);
    return clEnqueueWriteBuffer(queue, to, CL_TRUE, to_offset, size, bytes.data() + from_offset, waits, wait_for,
                                event);
}

cl_int clReleaseMemObject(cl_mem) { return CL_SUCCESS; }
}
