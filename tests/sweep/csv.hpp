// Tables of sweeps.
#pragma once

#include <sstream>
#include <string>

namespace test {

// Without the last column of a sweep.csv, the seconds.
inline std::string without_times(const std::string& csv) {
    std::istringstream lines(csv);
    std::string all;
    for (std::string line; std::getline(lines, line);) all += line.substr(0, line.rfind(',')) + "\n";
    return all;
}

}  // namespace test
