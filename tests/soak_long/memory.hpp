// How much memory this process has, on Linux.
#pragma once

namespace test {

double resident();   // VmRSS of /proc/self/status, MiB, after giving back what malloc holds in reserve
double allocated();  // handed out by malloc and not given back, MiB

}  // namespace test
