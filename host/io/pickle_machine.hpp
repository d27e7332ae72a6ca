// The operations of a pickle that makes arrays; all others are refused.
#pragma once

#include "io/pickle_value.hpp"

#include <string>
#include <string_view>

namespace pelage {

// What the pickle leaves, in `heap`. Throws Error with the file's `name`.
const PickleValue& run_pickle(std::string_view bytes, const std::string& name, PickleHeap& heap);

}  // namespace pelage
