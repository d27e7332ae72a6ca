// See expand.hpp.
#include "opencl/lattice/expand.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"

#include <string>

namespace pelage {

namespace {

cl::Kernel expand_kernel(const Session& session, const char* element) {
    Source source;
    source.file("common/prelude.cl").text(std::string("#define ELEMENT ") + element).file("lattice/expand.cl");
    return cl::Kernel(session.build(source.str()), "pelage_lattice_expand");
}

}  // namespace

void PlaneExpander::prepare(const Insertion& insertion) {
    if (insertion.picks.size() > capacity_) {
        capacity_ = insertion.picks.size() + insertion.picks.size() / 2;
        picks_ = session_.buffer(capacity_ * 4, "places of an expansion");
    }
    session_.queue().enqueueWriteBuffer(picks_, CL_TRUE, 0, insertion.picks.size() * 4, insertion.picks.data());
    by_column_ = insertion.column;
}

void PlaneExpander::apply(const cl::Buffer& from, const cl::Buffer& to, const Grid& grid, std::size_t planes,
                          bool integers, std::optional<std::uint32_t> birth) {
    const Grid after = grid.grown(by_column_);
    cl::Kernel& kernel = integers ? integers_ : scalars_;
    if (kernel() == nullptr) kernel = expand_kernel(session_, integers ? "int" : "scalar");
    Arguments(session_, kernel)
        .add(from, to, picks_, static_cast<cl_int>(by_column_), grid.columns, grid.rows, grid.pitch(), after.pitch(),
             planes, static_cast<cl_int>(birth.has_value()), static_cast<cl_int>(birth.value_or(0)));
    launch_over_rows(session_, kernel, after);
}

}  // namespace pelage
