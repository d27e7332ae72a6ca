// Programs under AddressSanitizer never unload what they have loaded: LeakSanitizer excuses what a driver keeps by the
// name of its module (driver_leaks.supp), which it knows of loaded ones alone, and Mesa unloads parts of its own.
extern "C" int dlclose(void*) { return 0; }
