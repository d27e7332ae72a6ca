// A sum over all charges, in double, one by one: what potentials are held against.
#pragma once

#include "core/aggregate.hpp"

#include <cmath>
#include <cstdint>

namespace test {

// Of term(charge, its distance from the site).
template <class Term>
double sum_over_charges(const pelage::Snapshot& state, const pelage::Front& front, std::uint32_t site, Term term) {
    double sum = 0.0;
    for (const std::uint32_t charge : front.charges()) {
        const double x = static_cast<double>(site % state.columns) - static_cast<double>(charge % state.columns);
        const double y = static_cast<double>(site / state.columns) - static_cast<double>(charge / state.columns);
        sum += term(charge, std::hypot(x, y));
    }
    return sum;
}

}  // namespace test
