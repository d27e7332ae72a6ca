// See subnormal.hpp. The functions stand in a file of their own, so that no compiler moves arithmetic across them.
#include "core/subnormal.hpp"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace pelage {

namespace {

#ifdef __SSE__
constexpr std::uint64_t mode = 0x8040;  // MXCSR: results to zero, operands are zero
std::uint64_t control() { return _mm_getcsr(); }
void set_control(std::uint64_t word) { _mm_setcsr(static_cast<unsigned>(word)); }
#elif defined(__aarch64__)
constexpr std::uint64_t mode = std::uint64_t{1} << 24;  // FPCR: flush to zero, operands and results
std::uint64_t control() {
    std::uint64_t word = 0;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word));
    return word;
}
void set_control(std::uint64_t word) { __asm__ volatile("msr fpcr, %0" : : "r"(word)); }
#else
constexpr std::uint64_t mode = 0;
std::uint64_t control() { return 0; }
void set_control(std::uint64_t) {}
#endif

}  // namespace

SubnormalsAreZero::SubnormalsAreZero(bool wanted) : wanted_(wanted) {
    if (!wanted_) return;
    before_ = control();
    set_control(before_ | mode);
}

// Flags of exceptions, which the same register may hold, stay as they are.
SubnormalsAreZero::~SubnormalsAreZero() {
    if (wanted_) set_control((control() & ~mode) | (before_ & mode));
}

bool processor_flushes() {
    const SubnormalsAreZero scope;
    volatile float small = 0x1p-120f;
    volatile float subnormal = 0x1p-130f;
    const volatile float result = small * 0x1p-20f;
    const volatile float grown = subnormal * 0x1p20f;
    return result == 0.0f && grown == 0.0f;
}

}  // namespace pelage
