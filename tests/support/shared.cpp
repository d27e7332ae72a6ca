// See shared.hpp.
#include "support/shared.hpp"

#include <cstdlib>
#include <iostream>

namespace test {

std::filesystem::path shared(const std::string& relative) {
    const char* root = std::getenv("PELAGE_SHARED");
    return std::filesystem::path(root != nullptr ? root : PELAGE_SHARED) / relative;
}

bool shared_missing(const std::string& relative) {
    if (std::filesystem::exists(shared(relative))) return false;
    std::cout << "SKIPPED: " << shared(relative).string() << " is not there\n";
    return true;
}

}  // namespace test
