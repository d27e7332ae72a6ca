// Step programs of free cells, compiled for the rules that act and kept.
#pragma once

#include "opencl/cells/source.hpp"
#include "opencl/device/session.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace pelage {

struct CellsStep {
    cl::Kernel there;  // from the arrays that hold the state to the spare ones; together: to and fro
    cl::Kernel back;   // alone
    CellsWritten written;
};

class CellsPrograms {
public:
    CellsPrograms(const Session&, const Experiment&, CellsPlan);

    const CellsPlan& plan() const { return plan_; }
    std::size_t width() const { return width_; }  // cells a work-item handles

    // The step for that iteration and all after it below `until`.
    CellsStep& at(std::uint64_t iteration, std::uint64_t& until, CellsForm);

    const cl::Buffer& parameters() const { return parameters_; }  // of the step that was asked for last

private:
    const Session& session_;
    const Experiment& experiment_;
    CellsPlan plan_;
    std::size_t width_;
    using Key = std::tuple<CellsForm, std::size_t, bool, std::vector<bool>>;  // phase, tests of intervals, rules
    std::map<Key, CellsStep> steps_;
    void upload(const Phase&);

    cl::Buffer parameters_;
    const Phase* uploaded_ = nullptr;  // whose numbers the buffer holds
};

}  // namespace pelage
