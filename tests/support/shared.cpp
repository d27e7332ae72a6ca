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
    // The folder as a whole is one cause, however many tests want a file of it.
    const std::filesystem::path missing = std::filesystem::exists(shared("")) ? shared(relative) : shared("");
    std::cout << "SKIPPED: the golden data in " << missing.lexically_normal().string()
              << " are not there (PELAGE_SHARED names their folder)\n";
    return true;
}

}  // namespace test
