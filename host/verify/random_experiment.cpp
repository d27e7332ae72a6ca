// See random_experiment.hpp.
#include "verify/random_experiment.hpp"

#include "verify/random_draft.hpp"

#include <fmt/format.h>

namespace pelage::verify {

std::string random_experiment(std::uint64_t seed, const RandomLimits& limits) {
    Draft draft(seed, limits);
    draft.line(fmt::format("// drawn from seed {}", seed));
    draw_world(draft);
    draw_course(draft);
    draw_pictures(draft);
    name_numbers(draft);
    return draft.text;
}

}  // namespace pelage::verify
