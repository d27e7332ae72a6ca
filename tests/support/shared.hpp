// Golden data of the papers' authors' own programs, found through PELAGE_SHARED; absent data skips a test by name.
#pragma once

#include <filesystem>
#include <string>

namespace test {

// PELAGE_SHARED/relative (the environment variable wins over the build's setting).
std::filesystem::path shared(const std::string& relative);

// True, after printing "SKIPPED: ...", when shared(relative) does not exist.
bool shared_missing(const std::string& relative);

}  // namespace test
