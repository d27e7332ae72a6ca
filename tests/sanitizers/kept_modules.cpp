// Linked with all programs under AddressSanitizer.
#include <cstdlib>

extern "C" {

// Nothing is ever unloaded: LeakSanitizer excuses what a driver keeps by the name of its module (driver_leaks.supp),
// which it knows of loaded ones alone, and Mesa unloads parts of its own.
int dlclose(void*) { return 0; }

// A test may do without the search for leaks (support/sanitizers.hpp).
int __lsan_is_turned_off() { return std::getenv("PELAGE_LEAKS_UNSEEN") != nullptr; }
}
