// See processor_time.hpp.
#include "app/processor_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace pelage::app {

// In /proc/PID/stat: "PID (NAME) STATE ...", the 14th and 15th word being ticks in the program and in the system.
double processor_seconds(pid_t process) {
    std::ifstream file(fmt::format("/proc/{}/stat", process));
    std::string line;
    std::getline(file, line);
    std::istringstream words(line.substr(std::min(line.size(), line.rfind(')') + 1)));
    std::string skipped;
    for (int i = 0; i < 11; ++i) words >> skipped;
    double program = 0, system = 0;
    if (!(words >> program >> system)) return 0;
    return (program + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace pelage::app
