// Builds small experiments by hand for tests.
#pragma once

#include "core/experiment.hpp"
#include "core/models.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace pelage::verify {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

// No bounds at all: the default of Bounds has a floor of 0.
inline constexpr Bounds unbounded{-infinite, infinite};

class Lab {
public:
    static Lab matrix(std::size_t columns, std::size_t rows, Boundary, Stencil = Stencil::nine_point);
    static Lab wide(std::size_t columns, std::size_t rows, Boundary);  // with 25 weights, all different
    static Lab volume(std::size_t columns, std::size_t rows, std::size_t layers, Boundary,
                      Stencil = Stencil::seven_point);
    static Lab grid(std::size_t columns, std::size_t rows, bool wrap);

    // Number of the new chemical. Deviations make the start uneven.
    std::size_t chemical(const std::string& name, Spread conc, Spread diff, Bounds bounds = {},
                         bool anisotropic = false);
    std::size_t mapping(const std::string& name);
    std::size_t expression(Expression);

    // The new rule, for from, until, every and offset; valid until the next one is added.
    Rule& rule(Action, Condition = Always{});

    // A new phase with the settings of the one before.
    Phase& phase(std::uint64_t begin);

    Lab& time_step(double dt);
    Lab& polarity(double degrees, double deviation);
    Lab& seed(std::int64_t);

    Experiment done() const;  // validated

private:
    Experiment experiment_;
    std::vector<Statement> uses_;
    Statement create_;
};

// Operands and conditions in few letters.
Operand number(double);
Operand quantity(Quantity, std::size_t index = 0);
Condition compare(Operand left, Comparison, Operand right);
React react(Model, std::vector<std::size_t> species, std::vector<double> parameters, double scale = 1.0);
// Values of a model's parameters with which each of them matters where its species have values from 0.5 to 4.5, others
// for each turn.
std::vector<double> sensible(const ModelFacts&, std::size_t turn);
// Drawn weights, so small that nothing grows without bound within a case.
std::shared_ptr<const Network> drawn_network(std::size_t chemicals, std::size_t hidden, std::uint64_t seed);
Change change(std::size_t chemical, Operand amount, double deviation = 0.0);
Change change_rate(std::size_t chemical, Operand amount, double deviation = 0.0);

}  // namespace pelage::verify
