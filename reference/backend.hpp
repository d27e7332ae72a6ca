// The reference: plain C++, one thread, written to be read beside the papers.
#pragma once

#include "core/tissue.hpp"

#include <memory>

namespace pelage {

// Runs every valid experiment. In double it is the truth other results are judged by, in float their equal.
std::unique_ptr<Backend> reference_backend(Precision);

}  // namespace pelage
