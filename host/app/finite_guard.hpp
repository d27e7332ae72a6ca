// Watches a run for NaN and infinity, and goes back to name the iteration that made them.
#pragma once

#include "core/tissue.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace pelage::app {

// The state after `finite_after` iterations was finite, the one after `iteration` is not. They are neighbours in
// time where the guard could go back; `where` is the first cell of the later state.
struct Breakdown {
    NonFinite where;
    std::uint64_t finite_after = 0;
    std::uint64_t iteration = 0;
};

class FiniteGuard {
public:
    static constexpr std::size_t largest_kept = 1'000'000;  // cells; beyond, no state to return to is kept

    explicit FiniteGuard(Tissue&);

    // To be called between batches. Upon a breakdown the tissue is left in the first state known to be non-finite.
    std::optional<Breakdown> look();

    // The latest state that it holds, which is finite.
    const std::optional<Snapshot>& kept() const { return kept_; }

private:
    using Clock = std::chrono::steady_clock;

    void keep();
    bool due() const;
    void narrow(Breakdown&);

    Tissue& tissue_;
    std::uint64_t finite_after_ = 0;
    std::optional<Snapshot> kept_;
    Clock::time_point kept_at_;
    Clock::duration cost_{};  // of reading the state once
};

std::string describe(const Breakdown&, const Tissue&);

}  // namespace pelage::app
