// An aggregate on a device: its buffers, and the launches of kernels/aggregate/device.cl.
#pragma once

#include "core/aggregate.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelage {

inline constexpr std::size_t most_particles_at_once = 256;

class DeviceAggregate {
public:
    // `sized`: charges are of different sizes.
    DeviceAggregate(std::shared_ptr<const Session>, bool sized);

    // With no `sums` they are added up anew.
    void upload(const Front&, const std::vector<std::int64_t>& sums);

    // How many the device may be given in one go.
    std::size_t particles_at_once(const Front&) const;

    // The sites that become charges, in order: as many as there are particles, or fewer where no candidate is left.
    // `front` is the state before; at most particles_at_once().
    std::vector<std::uint32_t> grow(const Front&, std::span<const Particle>);

    std::vector<std::int64_t> sums(std::size_t places) const;

private:
    bool build();
    void reserve(const Front&);
    void enlarge(cl::Buffer&, std::size_t bytes, const char* what);
    void fill(const cl::Buffer&, const void* from, std::size_t bytes) const;
    void write_front(const Front&);
    void bind(const Front&);
    void launch_step(std::size_t step, bool choose);

    std::shared_ptr<const Session> session_;
    bool sized_;
    std::size_t items_;  // of a group
    std::size_t groups_;
    std::size_t places_of_one_group_;
    cl::Kernel gather_, weigh_, choose_, together_, add_up_;
    std::size_t place_room_ = 0;
    std::size_t charge_room_ = 0;
    cl::Buffer places_, sums_, blocks_, left_;  // one a place, or a block of places
    cl::Buffer charges_, sizes_, sites_;
    cl::Buffer front_, particles_, chosen_, ranges_, parts_;
};

}  // namespace pelage
