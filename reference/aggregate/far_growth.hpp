// An aggregate that grows with a far field: the plain form. A choice looks at all candidates to find the highest sum,
// and then draws one: a leaf by a bound of its candidates' weights, a candidate in it by chance, which is taken with
// the probability weight / bound, or else there is another draw. So each is chosen by its weight, as Growth does it.
#pragma once

#include "core/aggregate.hpp"
#include "core/front.hpp"
#include "reference/aggregate/far_field.hpp"
#include "reference/aggregate/weight.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace pelage::reference {

class FarGrowth {
public:
    FarGrowth() = default;
    // Takes the charges of `front` one after another.
    explicit FarGrowth(Front front);

    // The site that the draws fall on; nothing where no candidate is left.
    std::optional<std::uint32_t> choose(const Particle&) const;
    void take(std::uint32_t site, float size = 1.0f);

    const Front& front() const { return front_; }
    std::vector<std::int64_t> sums() const;  // of size / r, one a place of the front, in parts

private:
    struct Leaf {
        std::vector<std::uint32_t> sites;  // of candidates
        std::vector<std::int64_t> near;    // what the charges of this leaf and those beside it add to their sums
        std::vector<std::int64_t> known;   // their sums, but for what far charges added since the last renewal
        std::vector<FarCharge> charges;
        std::int64_t lowest = std::numeric_limits<std::int64_t>::max();  // of what is known
    };
    // Weights that no candidate's own is above: of sums from `lower` to `upper`.
    struct Bounds {
        std::int64_t lower = 0, upper = 0;
        Weights weight;
        std::vector<std::uint64_t> totals;  // of blocks
    };

    FarCharge charge_at(std::uint32_t site, float size) const;
    std::size_t leaf_of(std::uint32_t site) const;
    template <class Visit>
    void each_near(std::uint32_t site, Visit&& visit) const;
    std::int64_t far_sum(std::uint32_t site) const;

    void add(std::uint32_t site, float size);
    void remove(std::uint32_t site);
    void pull_near(std::uint32_t site, float size);
    void offer(std::uint32_t site);
    void renew();

    Bounds bounds(std::int64_t highest, float eta) const;
    std::uint64_t bound(const Bounds&, const Leaf&) const;
    std::size_t descend(const Bounds&, std::uint64_t& drawn) const;
    std::uint32_t choose_of_all(const Particle&, std::uint64_t draw) const;

    Front front_;
    FarField field_;
    std::vector<Leaf> leaves_;
    std::vector<std::int32_t> sites_;  // as Front::sites(), but any candidate has the place 0
    std::uint64_t charges_ = 0;
    std::uint64_t candidates_ = 0;
    std::int64_t lowest_ = 0;  // since the last renewal, of all candidates
    int grain_ = 0;            // bounds are kept until the range of sums has moved by 2^grain
};

}  // namespace pelage::reference
