// See kept_handlers.hpp.
#include "opencl/device/kept_handlers.hpp"

#include <cstddef>

namespace pelage {

KeptHandlers::KeptHandlers() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], nullptr, &before_[i]);
}

KeptHandlers::~KeptHandlers() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
}

}  // namespace pelage
