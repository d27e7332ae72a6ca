// See gather.hpp.
#include "opencl/neighbours/gather.hpp"

#include "core/error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pelage {

namespace {

constexpr std::size_t wanted_group = 64;

std::string source_for(Arithmetic arithmetic) {
    Source source;
    if (arithmetic == Arithmetic::published) source.text("#define PELAGE_PUBLISHED\n");
    source.file("common/prelude.cl").file("common/exchange.cl").file("neighbours/gather.cl");
    return source.str();
}

template <class T>
cl::Buffer filled(const Session& session, const std::vector<T>& values, const char* what) {
    const std::size_t bytes = values.size() * sizeof(T);
    cl::Buffer buffer = session.buffer(bytes, what);
    if (bytes > 0) session.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, values.data());
    return buffer;
}

template <class T>
std::vector<T> converted(const std::vector<double>& values) {
    std::vector<T> made;
    made.reserve(values.size());
    for (const double value : values) made.push_back(in_precision<T>(value));
    return made;
}

std::vector<std::uint32_t> counted(const Adjacency& adjacency) {
    if (adjacency.indices.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(fmt::format("{} neighbours are more than a device can count", adjacency.indices.size()));
    }
    std::vector<std::uint32_t> offsets;
    offsets.reserve(adjacency.offsets.size());
    for (const std::size_t offset : adjacency.offsets) offsets.push_back(static_cast<std::uint32_t>(offset));
    return offsets;
}

}  // namespace

Gather::Gather(const Session& session, const Adjacency& adjacency, Arithmetic arithmetic)
    : session_(session),
      cells_(adjacency.cells()),
      kernel_(session.build(source_for(arithmetic)), "pelage_gather_neighbours"),
      offsets_(filled(session, counted(adjacency), "offsets of neighbours")),
      indices_(filled(session, adjacency.indices, "neighbours")),
      weights_(session.is_double() ? filled(session, adjacency.weights, "weights of neighbours")
                                   : filled(session, converted<float>(adjacency.weights), "weights of neighbours")) {}

void Gather::run(const cl::Buffer& rates, const cl::Buffer& old, const cl::Buffer& next, double dt) {
    Arguments(session_, kernel_).add(offsets_, indices_, weights_, rates, old, next, cells_, Scalar{dt});
    launch(session_, kernel_, cells_, session_.info().processor() ? 1 : wanted_group);
}

}  // namespace pelage
