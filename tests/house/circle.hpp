// Who includes whom, and whether that comes round to where it began.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace test {

using Includes = std::map<std::string, std::set<std::string>>;  // a room or a file, and those that it includes

// A way from `one` back to itself, one by one; empty where there is none.
std::vector<std::string> circle(const Includes& all, const std::string& one);

}  // namespace test
