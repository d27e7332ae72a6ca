// Several lattices of one structure that advance together, each with its own numbers, start and seed.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pelage {

struct BatchStart {
    std::shared_ptr<const Experiment> experiment;
    Snapshot state;
};

// Each member has the bits of a tissue of its own that is advanced alike. After advance() has failed half-way the
// states are lost.
class Batch {
public:
    virtual ~Batch() = default;
    Batch() = default;
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    virtual std::uint64_t iteration() const = 0;
    // Carries out whole iterations of all members that are not ended, with the events that fall into them.
    virtual void advance(std::uint64_t iterations) = 0;
    virtual Snapshot read(std::size_t member) const = 0;
    // No work is done for it any more, and it is not to be read again.
    virtual void end(std::size_t member) = 0;
    // How iterations have been carried out so far, a sentence each.
    virtual std::vector<std::string> report() const = 0;
};

}  // namespace pelage
