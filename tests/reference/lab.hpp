// Small lattices built by hand for the reference's tests.
#pragma once

#include "core/tissue.hpp"

#include <memory>
#include <string>
#include <vector>

namespace test {

// All: time step 1, concentrations and rates 0, no bounds, no rules.
pelage::Experiment matrix(std::size_t columns, std::size_t rows, pelage::Boundary = pelage::Boundary::no_flux,
                          pelage::Stencil = pelage::Stencil::nine_point, const std::vector<std::string>& names = {"A"});
pelage::Experiment volume(std::size_t columns, std::size_t rows, std::size_t layers,
                          pelage::Boundary = pelage::Boundary::no_flux, pelage::Stencil = pelage::Stencil::seven_point,
                          const std::vector<std::string>& names = {"A"});
pelage::Experiment grid(std::size_t columns, std::size_t rows, bool wrap,
                        const std::vector<std::string>& names = {"A"});

pelage::Rule rule(pelage::Action, pelage::Condition = pelage::Always{});
pelage::Operand number(double);
pelage::Condition compare(pelage::Operand, pelage::Comparison, pelage::Operand);

// The experiment's own first state; concentrations and rates may then be filled in.
pelage::Snapshot blank(const pelage::Experiment&);
std::unique_ptr<pelage::Tissue> start(const pelage::Experiment&, const pelage::Snapshot&,
                                      pelage::Precision = pelage::Precision::double_);

// The state after so many iterations from `initial`.
pelage::Snapshot after(std::uint64_t iterations, const pelage::Experiment&, const pelage::Snapshot& initial,
                       pelage::Precision = pelage::Precision::double_);

// Numbers of no pattern in [low, high), the same on every machine.
std::vector<double> scatter(std::size_t count, double low, double high, std::uint32_t seed);

double sum(const std::vector<double>&);
double spread(const std::vector<double>&);  // largest less smallest

// Every array of two states, bit for bit; NaN equals NaN.
bool same(const pelage::Snapshot&, const pelage::Snapshot&);

}  // namespace test
