// Free cells on the reference, straight from an experiment's text.
#pragma once

#include "core/neighbours.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace test {

std::unique_ptr<pelage::Tissue> cells(const std::string& text, pelage::Precision = pelage::Precision::double_,
                                      pelage::NeighbourSearch = pelage::NeighbourSearch::kd_tree);

// From a state of one's own instead of the text's.
std::unique_ptr<pelage::Tissue> cells(const std::string& text, const pelage::Snapshot& initial,
                                      pelage::Precision = pelage::Precision::double_,
                                      pelage::NeighbourSearch = pelage::NeighbourSearch::kd_tree);

pelage::Snapshot after(pelage::Tissue&, std::uint64_t iterations);  // advances, then reads
pelage::Snapshot initial(const std::string& text);

// The same state to the bit, iteration included.
bool same(const pelage::Snapshot&, const pelage::Snapshot&);

}  // namespace test
