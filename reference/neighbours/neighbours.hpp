// Exact neighbour sets on the reference, by a k-d tree.
#pragma once

#include "core/neighbours.hpp"

#include <span>

namespace pelage {

// All pairs with dx * dx + dy * dy < radius * radius, evaluated in T from dx = x[j] - x[i] (dy alike). A point
// without a finite place has no neighbours. Throws Error when x and y differ in length.
template <class T>
Neighbours neighbours_exact(std::span<const T> x, std::span<const T> y, T radius);

namespace reference {

// The same sets again and again while the points move little: candidates within radius + skin are kept until a point
// has strayed by nearly half the skin from where it was listed, so that none can come nearer than `radius` unseen.
// Points may be added behind the others; fewer points than before are points all new.
template <class T>
class NeighbourLists {
public:
    explicit NeighbourLists(T radius, T skin = static_cast<T>(0.4)) : radius_(radius), skin_(skin) {}

    // Neighbours of point i are those of candidates().of(i) that pass the strict test of neighbours_exact.
    void update(std::span<const T> x, std::span<const T> y);
    void forget();
    const Neighbours& candidates() const { return candidates_; }

private:
    std::vector<std::uint32_t> strayed(std::span<const T> x, std::span<const T> y) const;
    void relist(const std::vector<std::uint32_t>& points);

    T radius_;
    T skin_;
    Neighbours candidates_;
    std::vector<T> x_, y_;  // where each point was listed
};

extern template class NeighbourLists<float>;
extern template class NeighbourLists<double>;

}  // namespace reference

extern template Neighbours neighbours_exact(std::span<const float>, std::span<const float>, float);
extern template Neighbours neighbours_exact(std::span<const double>, std::span<const double>, double);

}  // namespace pelage
