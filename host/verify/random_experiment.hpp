// Experiments drawn at random from the whole language, for comparisons of backends that nobody has thought of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage::verify {

struct RandomShape {  // a file that `create shape` may name
    std::string file;
    std::size_t cells = 0;
};

struct RandomPicture {  // a file that `define chemical` may name; a matrix that shows it takes its size
    std::string file;
    std::size_t columns = 1;
    std::size_t rows = 1;
    std::vector<std::string> channels;  // that may be named; empty: none
};

struct RandomLimits {
    std::size_t cells = 400;        // most at the start; growth makes a few times as many of them
    std::uint64_t iterations = 48;  // most of a run, at least 4
    std::size_t chemicals = 5;      // most, 1 to 9
    std::size_t rules = 8;          // most, at least 1
    bool matrix = true;             // kinds of tissue; at least one of them
    bool sqr_grid = true;           // as a lattice
    bool free_cells = true;
    bool volume = true;
    bool mesh = true;
    bool charges = true;
    bool phases = true;
    bool extremes = true;                 // a few numbers at the ends of what a float holds, and runs that end in NaN
    std::vector<std::string> models;      // words of the reactions to draw from; empty: all of the table
    std::vector<RandomShape> shapes;      // in the folder that the text is parsed in
    std::vector<RandomPicture> pictures;  // likewise
};

// The text of an experiment that parse_experiment accepts: the same for the same seed and limits on every machine.
// Most runs of it stay finite. Throws Error when the limits leave nothing to draw.
std::string random_experiment(std::uint64_t seed, const RandomLimits& = {});

}  // namespace pelage::verify
