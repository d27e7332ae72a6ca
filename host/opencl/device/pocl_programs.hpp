// What PoCL has compiled, kept in our cache: PoCL leaves files in its folder, a part of them only when a kernel is
// first launched. They are put back before the same program is built again.
#pragma once

#include "opencl/device/cache.hpp"

#include <functional>

namespace pelage {

class Session;

// Carries out `build`, PoCL's build of the program that `key` stands for, after putting back what is kept of it. One
// thread at a time: PoCL's new folder is known by being new.
bool build_with_kept(const Session&, const CacheKey& key, const std::function<void()>& build);

// Keeps what has been compiled since of the programs that this session built, which must have come to rest.
void keep_compiled(const Session&);

// The same for all sessions, which go on: other processes find it from now on.
void keep_compiled();

}  // namespace pelage
