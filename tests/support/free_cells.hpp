// The same experiment of free cells on the reference and on the device, and what differs between two states.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"
#include "opencl/cells/tissue.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace test {

// Parses lines of the experiment language; shapes are looked for in the build's source folder.
std::shared_ptr<const pelage::Experiment> experiment(const std::string& text);
std::shared_ptr<const pelage::Experiment> experiment_file(const std::string& below_shared);

std::unique_ptr<pelage::Tissue> on_reference(std::shared_ptr<const pelage::Experiment>,
                                             pelage::Precision = pelage::Precision::single_);
std::unique_ptr<pelage::Tissue> on_device(std::shared_ptr<const pelage::Experiment>, const pelage::CellsOptions& = {},
                                          pelage::Precision = pelage::Precision::single_);

// The first difference, bit by bit, in words; no_difference when there is none.
inline const std::string no_difference;
std::string difference(const pelage::Snapshot& expected, const pelage::Snapshot& found);

// Advances both in equal strides until `iterations` have passed and checks after each that no bit differs and, at the
// end, that something has happened.
void check_equal_runs(pelage::Tissue& expected, pelage::Tissue& found, std::uint64_t iterations, std::uint64_t stride);

}  // namespace test
