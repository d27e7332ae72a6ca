// Where the parts of an experiment stand in its file: kept beside the Experiment for those who want to point at a line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

// Lines count from 1. The lists run along those of the Experiment of the same name; its rules know their own lines.
struct Outline {
    struct Statement {
        std::size_t line = 0;
        std::string what;       // "stop", "define domain", "colormap select": the words that tell its kind
        std::size_t phase = 0;  // how many phases have begun before it
    };
    std::vector<Statement> statements;  // all of them, in order
    std::vector<std::size_t> chemicals, mappings, prepattern, phases, outputs;
};

}  // namespace pelage
