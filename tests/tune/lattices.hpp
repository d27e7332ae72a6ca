// Lattices for the tests of the tuner.
#pragma once

#include "language/parse.hpp"

#include <fmt/format.h>

#include <string>

namespace test {

inline std::string spots_text(std::size_t columns, std::size_t rows, const std::string& more = "") {
    return fmt::format(
        "define chemical U limit 10\n"
        "define chemical V limit 10\n"
        "define time_step 0.01\n"
        "use chemical U conc 4 dev 0.5 diff 10\n"
        "use chemical V conc 4 dev 0.5 diff 2\n"
        "create matrix {} {} wrap\n"
        "rule always react U V turing alpha 16 beta 12\n"
        "{}stop at 5000\n",
        columns, rows, more);
}

inline pelage::Experiment spots(std::size_t columns, std::size_t rows, const std::string& more = "") {
    return pelage::parse_experiment(spots_text(columns, rows, more), "spots", ".");
}

}  // namespace test
