// Several iterations in one pass over memory, under any set of rules: what the streamed and the tiled kernel have in
// common (stream.hpp, tile.hpp).
#pragma once

#include "opencl/device/launch.hpp"
#include "opencl/lattice/fused_cut.hpp"
#include "opencl/lattice/step.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage {

class FusedStep : public LatticeKernel {
public:
    void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count, Pace&) final;

protected:
    // `source` and `kernel`: the program's text and the name of its kernel.
    using SourceOf = std::string (*)(const Experiment&, const LatticePlan&, const RuleText&,
                                     const std::vector<bool>& bounded, Precision, std::size_t width, const FusedShape&);
    FusedStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
              bool test_intervals, Choice, SourceOf source, const char* kernel);

    const Session& session() const { return session_; }
    const Choice& choice() const { return choice_; }

private:
    // The next launch of `count` iterations to come.
    virtual FusedLaunch next_launch(const Grid&, std::uint64_t count) const = 0;
    // What the kernel takes beyond that which all do.
    virtual void add_more(Arguments&, const FusedLaunch&, const cl::Buffer& parameters) = 0;

    void set_arguments(LatticeState&, const cl::Buffer& parameters, const FusedLaunch&, std::uint64_t first);
    void swap_planes(LatticeState&) const;

    const Session& session_;
    Choice choice_;
    std::uint64_t seed_;
    bool writes_rates_ = false;
    bool writes_polarity_ = false;
    bool writes_mappings_ = false;
    cl::Kernel kernel_;
};

}  // namespace pelage
