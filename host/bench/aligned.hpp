// A vector whose storage begins on a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace pelage::bench {

template <class T>
struct LineAllocator {
    using value_type = T;
    static constexpr std::align_val_t line{128};

    LineAllocator() = default;
    template <class Other>
    LineAllocator(const LineAllocator<Other>&) {}

    T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), line)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, line); }
    bool operator==(const LineAllocator&) const { return true; }
};

template <class T>
using Aligned = std::vector<T, LineAllocator<T>>;

}  // namespace pelage::bench
