// A part of a task that all ranks carry out alike.
#pragma once

#include "cluster/ranks.hpp"
#include "core/error.hpp"

#include <functional>

namespace pelage::cluster {

// What rank 0 throws where one of them failed: why.
struct FirstReason : Error {
    using Error::Error;
};

// What a rank other than 0 throws where one of them failed: rank 0 says why.
struct AnotherSaysWhy {};

// Where several ranks are: when `part` throws Error on any of them, it fails on all, with the first rank's reason. Rank
// 0 says it before the others end: with the first that ends, what starts ranks ends them all.
void together(Ranks*, const std::function<void()>& part);

}  // namespace pelage::cluster
