// A layer between this program and its OpenCL library: it counts calls and objects, makes calls fail and pretends that
// the machine is another one. layer.cpp puts it in the way of every call.
#pragma once

#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#include <CL/cl.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace test {

// One call that the program made. Calls from the same place in the program, reached along the same way, share a site.
struct Call {
    std::string name;
    std::size_t site = 0;
};

// What the layer pretends.
struct Machine {
    enum class Platform { real, empty, broken };  // empty: no devices; broken: clGetDeviceIDs fails

    std::vector<Platform> platforms{Platform::real};  // in order; none: CL_PLATFORM_NOT_FOUND_KHR
    std::map<cl_device_info, std::string> answers;    // bytes of the answer; empty: CL_INVALID_VALUE
    std::size_t largest_buffer = 0;                   // bytes; 0: as the device says. Larger ones are refused
    std::size_t memory = 0;                           // bytes of all buffers together; 0: as the device says
    std::size_t work_group = 0;                       // work-items; 0: as the device says. Larger ones are refused
    bool no_double = false;                           // and programs that use the word are not compiled
    bool binaries = true;                             // false: the device takes no compiled programs

    template <class T>
    void answer(cl_device_info what, T value) {
        answers[what] = std::string(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void work_group_limit(std::size_t items);
    void largest_buffer_limit(std::size_t bytes);
    void memory_limit(std::size_t bytes);
    void without_double();
};

class Faults {
public:
    // The one in the way of this program's calls. A test starts with reset().
    static Faults& layer();

    // Forgets faults, pretences and counts, and gives back to the library what is still held.
    void reset();

    // Forgets faults and calls, and keeps what is held.
    void heal();

    // Calls are counted from 0 since reset() or heal().
    void fail(std::size_t nth, cl_int code) { faults_.push_back({"", nth, code, false, {}}); }
    void fail(const std::string& name, std::size_t nth, cl_int code) {
        faults_.push_back({name, nth, code, false, {}});
    }
    // From that call on every call fails with CL_DEVICE_NOT_AVAILABLE, releases too.
    void lose_device(std::size_t nth) { faults_.push_back({"", nth, CL_DEVICE_NOT_AVAILABLE, true, {}}); }
    void lose_device_after(std::chrono::milliseconds time) {
        faults_.push_back({"", 0, CL_DEVICE_NOT_AVAILABLE, true, Clock::now() + time});
    }

    Machine machine;

    std::size_t struck() const { return struck_; }    // how many calls were made to fail
    std::size_t refused() const { return refused_; }  // how many buffers the machine had no memory for
    const std::vector<Call>& calls() const { return calls_; }
    std::size_t count(const std::string& name) const;
    std::size_t bytes() const { return bytes_; }            // of all buffers that are held
    std::size_t most_bytes() const { return most_bytes_; }  // at any one time

    // Objects that the program did not give back, and those that it gave back too often. A release that was made to
    // fail counts as one.
    std::vector<std::string> unbalanced() const;

    // Used by the layer itself.
    cl_int enter(const char* name);
    void created(const char* kind, void* object, std::size_t bytes = 0);
    void retained(const char* kind, void* object);
    void released(const char* kind, void* object);
    void not_released(void* object);
    cl_int refuse_buffer(std::size_t bytes);

private:
    using Clock = std::chrono::steady_clock;

    struct Fault {
        std::string name;  // empty: any
        std::size_t nth = 0;
        cl_int code = CL_SUCCESS;
        bool lasting = false;
        std::optional<Clock::time_point> from;
    };
    struct Object {
        std::string kind;
        std::ptrdiff_t references = 0;
        std::ptrdiff_t failed_releases = 0;
        std::size_t bytes = 0;
    };

    void give_back();

    std::vector<Fault> faults_;
    std::size_t struck_ = 0;
    std::size_t refused_ = 0;
    std::vector<Call> calls_;
    std::map<std::string, std::size_t> counts_;
    std::map<void*, Object> objects_;
    std::vector<std::string> excess_;
    std::size_t bytes_ = 0;
    std::size_t most_bytes_ = 0;
};

// The library's own function, behind the layer.
void* library_function(const char* name);

template <class Function>
Function* behind(const char* name) {
    return reinterpret_cast<Function*>(library_function(name));
}

}  // namespace test
