// See resample.hpp.
#include "opencl/lattice/resample.hpp"

#include "core/subnormal.hpp"
#include "opencl/device/program.hpp"

#include <algorithm>
#include <string>
#include "opencl/device/launch.hpp"

namespace pelage {

namespace {

cl::Kernel built(const Session& session, const char* element, const char* name) {
    Source source;
    source.file("common/prelude.cl").text(std::string("#define ELEMENT ") + element).file("lattice/resample.cl");
    return cl::Kernel(session.build(source.str()), name);
}

}  // namespace

cl::Buffer PlaneResampler::integers(const std::vector<std::int32_t>& values) const {
    cl::Buffer buffer = session_.buffer(std::max<std::size_t>(values.size(), 1) * 4, "sources of an interpolation");
    if (!values.empty()) session_.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, values.size() * 4, values.data());
    return buffer;
}

cl::Buffer PlaneResampler::scalars(const std::vector<double>& values) const {
    const std::size_t bytes = values.size() * session_.scalar_bytes();
    cl::Buffer buffer = session_.buffer(std::max<std::size_t>(bytes, 8), "weights of an interpolation");
    if (values.empty()) return buffer;
    if (session_.is_double()) {
        session_.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, values.data());
    } else {
        std::vector<float> singles(values.size());
        std::transform(values.begin(), values.end(), singles.begin(), in_precision<float>);
        session_.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, singles.data());
    }
    return buffer;
}

PlaneResampler::Axis PlaneResampler::axis(const Sampling& sampling) const {
    return {integers(sampling.nearest), integers(sampling.sources), scalars(sampling.weights)};
}

void PlaneResampler::prepare(const Resampling& resampling, const std::vector<Bounds>& bounds) {
    across_ = axis(resampling.across);
    up_ = axis(resampling.up);
    others_ = resampling.across.others;
    after_ = {resampling.across.places, resampling.up.places};
    std::vector<double> pairs;
    for (const Bounds& one : bounds) pairs.insert(pairs.end(), {one.floor, one.limit});
    bounds_ = scalars(pairs);
}

void PlaneResampler::interpolate(const cl::Buffer& from, const cl::Buffer& to, const Grid& before, std::size_t planes) {
    if (interpolate_() == nullptr) interpolate_ = built(session_, "scalar", "pelage_lattice_interpolate");
    Arguments(session_, interpolate_)
        .add(from, to, across_.sources, across_.weights, up_.sources, up_.weights, bounds_, others_, before.rows,
             before.pitch(), after_.columns, after_.rows, after_.pitch(), planes);
    launch_over_rows(session_, interpolate_, after_);
}

void PlaneResampler::take_nearest(const cl::Buffer& from, const cl::Buffer& to, const Grid& before, std::size_t planes,
                                  bool integers) {
    cl::Kernel& kernel = integers ? nearest_integers_ : nearest_scalars_;
    if (kernel() == nullptr) kernel = built(session_, integers ? "int" : "scalar", "pelage_lattice_nearest");
    Arguments(session_, kernel)
        .add(from, to, across_.nearest, up_.nearest, before.rows, before.pitch(), after_.columns, after_.rows,
             after_.pitch(), planes);
    launch_over_rows(session_, kernel, after_);
}

}  // namespace pelage
