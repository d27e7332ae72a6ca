// A part of a task that all ranks carry out alike.
#pragma once

#include "cluster/ranks.hpp"

#include <functional>

namespace pelage::cluster {

// What a rank other than 0 throws where one of them failed: rank 0 says why.
struct AnotherSaysWhy {};

// Where several ranks are: when `part` throws Error on any of them, it fails on all, with the first rank's reason.
void together(Ranks*, const std::function<void()>& part);

}  // namespace pelage::cluster
