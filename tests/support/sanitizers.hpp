// What a test cannot do under a sanitizer.
#pragma once

#include <cstdlib>
#include <iostream>

namespace test {

// True, after printing "SKIPPED: ...", where a sanitizer reserves terabytes of addresses: a process under it starts
// with no limit on them.
inline bool addresses_are_reserved() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    std::cout << "SKIPPED: a sanitizer reserves more addresses than any limit leaves\n";
    return true;
#else
    return false;
#endif
}

// LeakSanitizer dies where it stops some threads of a driver ("Tracer caught signal 11"): such a test, and what it
// starts, goes without.
inline void overlook_leaks() { setenv("PELAGE_LEAKS_UNSEEN", "1", 1); }

}  // namespace test
