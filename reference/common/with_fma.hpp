// Where the processor has fma the compiler may use it in some functions: those in whose sums most of a run's time goes
// by.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__)
#define PELAGE_WITH_FMA __attribute__((target("avx2,fma"), flatten))
#define PELAGE_INLINE inline __attribute__((always_inline))
#else
#define PELAGE_INLINE inline
#endif

namespace pelage::reference {

// Whether functions that are marked PELAGE_WITH_FMA run here.
inline bool runs_with_fma() {
#ifdef PELAGE_WITH_FMA
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

}  // namespace pelage::reference
