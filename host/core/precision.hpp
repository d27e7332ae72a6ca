// The precision of a run's numbers.
#pragma once

namespace pelage {

enum class Precision { single_, double_ };

}  // namespace pelage
