// Stretches planes on the device: growth of a lattice by interpolation.
#pragma once

#include "core/experiment.hpp"
#include "core/resampling.hpp"
#include "opencl/lattice/planes.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

// Shared by all planes of a tissue.
class PlaneResampler {
public:
    explicit PlaneResampler(const Session& session) : session_(session) {}

    // Makes the sources and weights known to the device, and the bounds, one a chemical.
    void prepare(const Resampling&, const std::vector<Bounds>&);
    Grid after() const { return after_; }

    // From planes of `before` in one buffer to planes of after() in another.
    void interpolate(const cl::Buffer& from, const cl::Buffer& to, const Grid& before, std::size_t planes);
    void take_nearest(const cl::Buffer& from, const cl::Buffer& to, const Grid& before, std::size_t planes,
                      bool integers);

private:
    struct Axis {
        cl::Buffer nearest, sources, weights;
    };

    Axis axis(const Sampling&) const;
    cl::Buffer integers(const std::vector<std::int32_t>&) const;
    cl::Buffer scalars(const std::vector<double>&) const;

    const Session& session_;
    cl::Kernel interpolate_;  // built when first needed
    cl::Kernel nearest_scalars_;
    cl::Kernel nearest_integers_;
    Axis across_, up_;
    cl::Buffer bounds_;
    std::size_t others_ = 0;
    Grid after_;
};

}  // namespace pelage
