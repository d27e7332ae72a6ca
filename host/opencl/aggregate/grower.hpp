// What grows an aggregate on a device, and what all that do so share.
#pragma once

#include "core/aggregate.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelage {

inline constexpr std::size_t most_particles_at_once = 256;
inline constexpr std::size_t most_new_candidates = 8;  // that one charge makes

class Grower {
public:
    virtual ~Grower() = default;

    // With no `sums` they are added up anew.
    virtual void upload(const Front&, const std::vector<std::int64_t>& sums) = 0;

    // How many particles the device may be given in one go.
    virtual std::size_t particles_at_once(const Front&) const = 0;

    // The sites that become charges, in order: as many as there are particles, or fewer where no candidate is left.
    // `front` is the state before; at most particles_at_once().
    virtual std::vector<std::uint32_t> grow(const Front&, std::span<const Particle>) = 0;

    // Of size / r, one a place of the front, in parts.
    virtual std::vector<std::int64_t> sums(const Front&) const = 0;

    // Of the buffers that grow with the candidates.
    virtual std::size_t candidate_bytes() const = 0;
};

// A site as kernels/aggregate/terms.cl has it, and back.
cl_uint packed_site(std::uint32_t site, std::size_t columns);
std::uint32_t unpacked_site(cl_uint site, std::size_t columns);

// Work-items of a group, a power of two and at most `most`. A processor takes one item a group, whose loops its
// compiler turns into vectors.
std::size_t growing_items(const Session&, std::size_t most);

// Whether each of the kernels can be carried out by groups of so many work-items.
bool groups_fit(const Session&, std::span<const cl::Kernel>, std::size_t items);

void fill(const Session&, const cl::Buffer& to, const void* from, std::size_t bytes);
// Keeps what the buffer holds.
void enlarge(const Session&, cl::Buffer&, std::size_t bytes, const char* what);

}  // namespace pelage
