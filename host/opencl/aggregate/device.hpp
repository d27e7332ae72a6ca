// An aggregate on a device: its buffers, and the launches of kernels/aggregate/device.cl.
#pragma once

#include "opencl/aggregate/grower.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelage {

class DeviceAggregate final : public Grower {
public:
    // `sized`: charges are of different sizes.
    DeviceAggregate(std::shared_ptr<const Session>, bool sized);

    void upload(const Front&, const std::vector<std::int64_t>& sums) override;
    std::size_t places_added_up_at_once(std::size_t charges) const;
    std::size_t particles_at_once(const Front&) const override;
    std::vector<std::uint32_t> grow(const Front&, std::span<const Particle>) override;
    std::vector<std::int64_t> sums(const Front&) const override;
    std::size_t candidate_bytes() const override;

private:
    bool build();
    void reserve(const Front&);
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
