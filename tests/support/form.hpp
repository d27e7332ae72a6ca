// The forms in which a test may run: all that it has, or a part of it; programs as they are, or as PoCL optimises them.
#pragma once

#include "support/variable.hpp"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace test {

// The labels of long tests ask for all that a test has; without them it takes the part that it can do in a few seconds.
inline bool long_form() { return std::getenv("PELAGE_LONG_FORM") != nullptr; }

// Programs as PoCL optimises them, for a test whose many iterations take longer than that. It comes before the first
// use of the device.
class Optimised {
public:
    Optimised() : flags_("POCL_EXTRA_BUILD_FLAGS", nullptr) {
        const char* const cache = std::getenv("PELAGE_CACHE");
        if (cache == nullptr) return;
        const std::filesystem::path folder(cache);
        if (folder.filename() == "cache-unoptimised")
            cache_.emplace("PELAGE_CACHE", (folder.parent_path() / "cache").c_str());
    }

private:
    Variable flags_;
    std::optional<Variable> cache_;
};

}  // namespace test
