// One table of experiments on lattices and in volumes, for tests and benchmarks: every case runs on every backend.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pelage::verify {

struct Size {
    std::size_t columns = 1;
    std::size_t rows = 1;
    std::size_t layers = 0;  // of a volume

    std::size_t cells() const { return columns * rows * (layers == 0 ? 1 : layers); }
    std::string text() const;  // "19 x 11"
};

struct Case {
    std::string name;
    std::function<Experiment(Size)> experiment;
    std::vector<Size> sizes;
    std::uint64_t iterations = 100;
    std::function<void(Snapshot&)> touch = {};  // changes the first state to what no prepattern can make; may be empty
    bool grows = false;                         // expands: compare after every iteration
    bool divides = false;  // divides or takes square roots: exact only where the device rounds these correctly
};

// The table, in order of name parts: "diffusion/...", "saturation/...", "reaction/...", "rates/...", "rules/...",
// "growth/...", "neural/...", "values/...", "sizes/...", "volume/...".
const std::vector<Case>& lattice_cases();

// The case of that name. Throws std::out_of_range.
const Case& lattice_case(const std::string& name);

// Parts of the table.
std::vector<Case> diffusion_cases();
std::vector<Case> reaction_cases();
std::vector<Case> rate_cases();
std::vector<Case> rule_cases();
std::vector<Case> growth_cases();
std::vector<Case> neural_cases();
std::vector<Case> extreme_cases();  // saturation, special values, sizes
std::vector<Case> volume_cases();
std::vector<Case> timed_cases();  // of lattices and of volumes

// 1x1, lines, tiny rectangles, around a vector's and a work-group's width, primes.
std::vector<Size> sharp_sizes();
std::vector<Size> few_sizes();  // some of them

const char* word(Boundary);
const char* word(Stencil);

}  // namespace pelage::verify
