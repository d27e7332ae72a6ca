// Small files of other programs, and what an import makes of them.
#pragma once

#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "import/import.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "support/process.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace test {

// A pattern of Ready, written part by part.
struct Pattern {
    std::string formula = "delta_a = laplacian_a;";
    std::size_t chemicals = 1;
    std::vector<std::pair<std::string, std::string>> parameters{{"timestep", "0.1"}};
    std::string generator = "<initial_pattern_generator apply_when_loading=\"true\"/>";
    std::string extent = "0 7 0 5 0 0";
    std::string rule = "type=\"formula\" name=\"Test\"";
    std::string file = "byte_order=\"LittleEndian\"";  // attributes of VTKFile
    std::string data;                                  // DataArrays
    std::string appended;
};

std::string text_of(const Pattern&);
std::string overlay(const std::string& chemical, const std::string& inside);  // overwrite, unless `inside` says else

pelage::imports::Import imported(const std::string& bytes);
pelage::imports::Import imported(const Pattern&);
std::string refusal(const std::string& bytes);                                   // the message; empty: it was taken
pelage::Snapshot run(const pelage::imports::Import&, std::uint64_t iterations);  // in double, on the reference

}  // namespace test
