// See faults.hpp.
#include "faults.hpp"

#include <dlfcn.h>
#include <execinfo.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace test {

namespace {

constexpr int deepest = 10;  // frames that tell one call from another
constexpr int own_frames = 2;

// Told apart by the addresses that the call will return to.
std::size_t call_site() {
    std::array<void*, deepest> frames{};
    const int count = backtrace(frames.data(), deepest);
    std::size_t hash = 0xcbf29ce484222325u;
    for (int i = own_frames; i < count; ++i) {
        hash = (hash ^ reinterpret_cast<std::size_t>(frames[static_cast<std::size_t>(i)])) * 0x100000001b3u;
    }
    return hash;
}

template <class Handle>
void release_by(const char* function, void* object) {
    behind<cl_int(Handle)>(function)(static_cast<Handle>(object));
}

// To the library itself; devices need no giving back.
void release(const std::string& kind, void* object) {
    if (kind == "kernel") release_by<cl_kernel>("clReleaseKernel", object);
    if (kind == "event") release_by<cl_event>("clReleaseEvent", object);
    if (kind == "buffer") release_by<cl_mem>("clReleaseMemObject", object);
    if (kind == "program") release_by<cl_program>("clReleaseProgram", object);
    if (kind == "queue") release_by<cl_command_queue>("clReleaseCommandQueue", object);
    if (kind == "context") release_by<cl_context>("clReleaseContext", object);
}

}  // namespace

void* library_function(const char* name) {
    void* found = dlsym(RTLD_NEXT, name);
    static void* const library = dlopen("libOpenCL.so.1", RTLD_NOW);
    if (found == nullptr && library != nullptr) found = dlsym(library, name);
    if (found == nullptr) throw std::runtime_error(std::string("no OpenCL library has ") + name);
    return found;
}

void Machine::work_group_limit(std::size_t items) {
    work_group = items;
    answer(CL_DEVICE_MAX_WORK_GROUP_SIZE, items);
    answer(CL_DEVICE_MAX_WORK_ITEM_SIZES, std::array<std::size_t, 3>{items, items, items});
}

void Machine::largest_buffer_limit(std::size_t bytes) {
    largest_buffer = bytes;
    answer(CL_DEVICE_MAX_MEM_ALLOC_SIZE, static_cast<cl_ulong>(bytes));
}

void Machine::memory_limit(std::size_t bytes) { memory = bytes; }

void Machine::without_double() {
    no_double = true;
    answer(CL_DEVICE_DOUBLE_FP_CONFIG, cl_device_fp_config{0});
    answer(CL_DEVICE_NATIVE_VECTOR_WIDTH_DOUBLE, cl_uint{0});
    answer(CL_DEVICE_PREFERRED_VECTOR_WIDTH_DOUBLE, cl_uint{0});
}

Faults& Faults::layer() {
    static Faults faults;
    return faults;
}

void Faults::reset() {
    give_back();
    heal();
    machine = {};
    excess_.clear();
    bytes_ = most_bytes_ = 0;
}

void Faults::heal() {
    faults_.clear();
    calls_.clear();
    counts_.clear();
    struck_ = refused_ = 0;
}

std::size_t Faults::count(const std::string& name) const {
    const auto found = counts_.find(name);
    return found == counts_.end() ? 0 : found->second;
}

std::vector<std::string> Faults::unbalanced() const {
    std::vector<std::string> texts = excess_;
    for (const auto& [unused, object] : objects_) {
        if (object.references > object.failed_releases) texts.push_back(object.kind + " was not given back");
        if (object.references < 0) texts.push_back(object.kind + " was given back too often");
    }
    return texts;
}

cl_int Faults::enter(const char* name) {
    const std::size_t nth_of_name = counts_[name]++;
    const std::size_t nth = calls_.size();
    calls_.push_back({name, call_site()});
    for (const Fault& fault : faults_) {
        if (!fault.name.empty() && fault.name != name) continue;
        const std::size_t at = fault.name.empty() ? nth : nth_of_name;
        if (fault.lasting ? at < fault.nth : at != fault.nth) continue;
        if (fault.from && Clock::now() < *fault.from) continue;
        ++struck_;
        return fault.code;
    }
    return CL_SUCCESS;
}

void Faults::created(const char* kind, void* object, std::size_t bytes) {
    if (object == nullptr) return;
    objects_[object] = {kind, 1, 0, bytes};
    bytes_ += bytes;
    most_bytes_ = std::max(most_bytes_, bytes_);
}

void Faults::retained(const char* kind, void* object) {
    Object& held = objects_[object];
    held.kind = kind;
    ++held.references;
}

void Faults::released(const char* kind, void* object) {
    const auto found = objects_.find(object);
    if (found == objects_.end()) {
        excess_.push_back(std::string(kind) + " was given back though it was not held");
        return;
    }
    if (--found->second.references != 0) return;
    bytes_ -= found->second.bytes;
    objects_.erase(found);
}

void Faults::not_released(void* object) {
    const auto found = objects_.find(object);
    if (found != objects_.end()) ++found->second.failed_releases;
}

cl_int Faults::refuse_buffer(std::size_t bytes) {
    const bool too_large = machine.largest_buffer != 0 && bytes > machine.largest_buffer;
    const bool too_many = machine.memory != 0 && bytes_ + bytes > machine.memory;
    if (too_large || too_many) ++refused_;
    return too_large ? CL_INVALID_BUFFER_SIZE : too_many ? CL_MEM_OBJECT_ALLOCATION_FAILURE : CL_SUCCESS;
}

void Faults::give_back() {
    for (const auto& [address, object] : objects_) {
        for (std::ptrdiff_t i = 0; i < object.references; ++i) release(object.kind, address);
    }
    objects_.clear();
}

}  // namespace test
