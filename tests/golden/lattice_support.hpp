// Lattice experiments built by hand and golden arrays to hold them against.
#pragma once

#include "core/tissue.hpp"
#include "io/npy.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace test {

// An array of the golden data; `relative` is below golden/ and lacks the ending .npy.
pelage::NpyArray golden(const std::string& relative);

struct Difference {
    double largest = 0.0;     // of any two values
    double range = 0.0;       // highest less lowest golden value
    double magnitude = 0.0;   // of the largest golden value
    std::size_t unequal = 0;  // values, +0 and -0 being equal; NaN equals nothing
    double relative() const { return range > 0.0 ? largest / range : largest; }
};

// Throws std::runtime_error where the two differ in length or there is nothing to compare.
Difference difference(const std::vector<double>& found, const std::vector<double>& golden);

// A chemical of a hand-built matrix.
struct Substance {
    std::string name;
    double rate = 0.0;
    pelage::Bounds bounds;
};

// A matrix without rules.
pelage::Experiment matrix(std::size_t columns, std::size_t rows, pelage::Boundary, pelage::Stencil, double time_step,
                          const std::vector<Substance>&);
pelage::Rule always(pelage::Action);

// The experiment's lattice in the shape of the arrays with these concentrations, at iteration 0, on the reference.
std::unique_ptr<pelage::Tissue> start(const pelage::Experiment&, const std::vector<pelage::NpyArray>& concentrations,
                                      pelage::Precision = pelage::Precision::double_);

}  // namespace test
