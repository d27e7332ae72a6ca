// Builds small experiments by hand for tests.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace test {

// No bounds at all: the default of pelage::Bounds has a floor of 0.
inline constexpr pelage::Bounds unbounded{-std::numeric_limits<double>::infinity(),
                                          std::numeric_limits<double>::infinity()};

class Lab {
public:
    static Lab matrix(std::size_t columns, std::size_t rows, pelage::Boundary,
                      pelage::Stencil = pelage::Stencil::nine_point);
    static Lab grid(std::size_t columns, std::size_t rows, bool wrap);

    // Number of the new chemical. Deviations make the start uneven.
    std::size_t chemical(const std::string& name, pelage::Spread conc, pelage::Spread diff, pelage::Bounds bounds = {},
                         bool anisotropic = false);
    std::size_t mapping(const std::string& name);

    // The new rule, for from, until, every and offset; valid until the next one is added.
    pelage::Rule& rule(pelage::Action, pelage::Condition = pelage::Always{});

    // A new phase with the settings of the one before.
    pelage::Phase& phase(std::uint64_t begin);

    Lab& time_step(double dt);
    Lab& polarity(double degrees, double deviation);
    Lab& seed(std::int64_t);

    pelage::Experiment done() const;  // validated

private:
    pelage::Experiment experiment_;
    std::vector<pelage::Statement> uses_;
    pelage::Statement create_;
};

// Operands and conditions in few letters.
pelage::Operand number(double);
pelage::Operand quantity(pelage::Quantity, std::size_t index = 0);
pelage::Condition compare(pelage::Operand left, pelage::Comparison, pelage::Operand right);
pelage::React react(pelage::Model, std::size_t u, std::size_t v, std::vector<double> parameters, double scale = 1.0);
pelage::Change change(std::size_t chemical, pelage::Operand amount, double deviation = 0.0);
pelage::Change change_rate(std::size_t chemical, pelage::Operand amount, double deviation = 0.0);

}  // namespace test
