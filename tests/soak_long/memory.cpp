// See memory.hpp.
#include "soak_long/memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace test {

double resident() {
    malloc_trim(0);
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word != "VmRSS:") continue;
        double kibibytes = 0.0;
        status >> kibibytes;
        return kibibytes / 1024.0;
    }
    return 0.0;
}

double allocated() {
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / 1048576.0;
}

}  // namespace test
