// Columns and rows inserted into planes on the device; see kernels/lattice/expand.cl.
#pragma once

#include "core/growth.hpp"
#include "opencl/device/session.hpp"
#include "opencl/lattice/planes.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace pelage {

// Duplicates elements of planes on the device; shared by all planes of a tissue.
class PlaneExpander {
public:
    explicit PlaneExpander(const Session& session) : session_(session) {}

    // Makes the picks known to the device; then apply() moves planes of `grid` from one buffer to another. With
    // `birth` the planes hold births, and that is the duplicates'.
    void prepare(const Insertion&);
    void apply(const cl::Buffer& from, const cl::Buffer& to, const Grid&, std::size_t planes, bool integers,
               std::optional<std::uint32_t> birth);

private:
    const Session& session_;
    cl::Kernel scalars_;  // built when first needed
    cl::Kernel integers_;
    cl::Buffer picks_;
    std::size_t capacity_ = 0;
    bool by_column_ = true;
};

}  // namespace pelage
