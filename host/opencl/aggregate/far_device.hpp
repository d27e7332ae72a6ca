// An aggregate with a far field on a device: its buffers, and the launches of kernels/aggregate/far_device.cl.
#pragma once

#include "core/far_grid.hpp"
#include "opencl/aggregate/grower.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelage {

class DeviceFarAggregate final : public Grower {
public:
    // `sized`: charges are of different sizes.
    DeviceFarAggregate(std::shared_ptr<const Session>, bool sized, FarGrid);

    // Takes the charges of `front` one after another.
    void upload(const Front& front, const std::vector<std::int64_t>& sums) override;
    std::size_t particles_at_once(const Front&) const override;
    std::vector<std::uint32_t> grow(const Front&, std::span<const Particle>) override;
    std::vector<std::int64_t> sums(const Front&) const override;
    std::size_t candidate_bytes() const override;

private:
    bool build();
    void clear(const Front&);
    void clear_states(const Front&);
    void reserve(std::size_t more);
    void reserve_candidates(std::size_t chunks);
    void reserve_charges(std::size_t chunks);
    std::size_t count_chunks();
    cl_uint bind(cl::Kernel&) const;
    void run(const cl::Kernel&, std::size_t groups) const;
    void replay(const Front&, std::size_t first, std::size_t count);
    void renew();
    std::size_t looking_groups() const;

    std::shared_ptr<const Session> session_;
    bool sized_;
    FarGrid grid_;
    std::size_t items_;  // of a group
    mutable cl::Kernel grow_, replay_, look_, renew_;
    cl::Buffer levels_, tables_, front_, leaves_, looked_at_;
    cl::Buffer coefficients_, added_, best_, totals_;       // of blocks
    cl::Buffer states_;                                     // of sites
    cl::Buffer sites_, near_, known_, next_;                // of candidates
    cl::Buffer charges_, sizes_, charge_next_;              // of charges
    cl::Buffer particles_, chosen_;                         // of a batch
    std::size_t columns_ = 0, rows_ = 0;                    // of sites
    std::size_t candidate_room_ = 0, charge_room_ = 0;      // in chunks
    std::size_t candidate_chunks_ = 0, charge_chunks_ = 0;  // in use, at most
};

}  // namespace pelage
