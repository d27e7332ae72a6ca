// See interaction.hpp.
#include "reference/cells/interaction.hpp"

#include <cmath>
#include <span>

namespace pelage::reference {

namespace {

template <class T>
struct Near {  // a neighbour seen from the cell at hand
    std::uint32_t id;
    T dx, dy;
    T norm;  // distance
};

template <class T>
void see(const Interaction<T>& way, std::span<const std::uint32_t> candidates, const State<T>& old, std::size_t cell,
         std::vector<Near<T>>& seen) {
    constexpr T square = static_cast<T>(interaction_range * interaction_range);
    seen.clear();
    for (const std::uint32_t id : candidates) {
        const T dx = old.x[id] - old.x[cell];
        const T dy = old.y[id] - old.y[cell];
        const T d2 = dx * dx + dy * dy;
        if (!way.exact || d2 < square) seen.push_back({id, dx, dy, std::sqrt(d2)});
    }
}

// |d . p| / |d| for a cell with a polarity, else 1.
template <class T>
T along(const Near<T>& near, T px, T py) {
    if ((px == T(0) && py == T(0)) || near.norm == T(0)) return T(1);
    return std::fabs(near.dx * px + near.dy * py) / near.norm;
}

template <class T>
T harmonic_mean(T a, T b) {
    return a == b ? a : (T(2) * (a * b)) / (a + b);
}

template <class T>
void diffuse(const Interaction<T>& way, const std::vector<Near<T>>& seen, const State<T>& old, std::size_t cell,
             State<T>& next) {
    for (std::size_t chemical = 0; chemical < old.conc.size(); ++chemical) {
        if (way.diffuses[chemical] == 0) continue;
        const std::vector<T>& conc = old.conc[chemical];
        const std::vector<T>& rate = old.diff[chemical];
        T sum = next.conc[chemical][cell];
        for (const Near<T>& near : seen) {
            T mine = rate[cell];
            T theirs = rate[near.id];
            if (way.anisotropic[chemical] != 0) {
                mine = mine * along(near, old.polarity_x[cell], old.polarity_y[cell]);
                theirs = theirs * along(near, old.polarity_x[near.id], old.polarity_y[near.id]);
            }
            sum = sum + (harmonic_mean(mine, theirs) * (conc[near.id] - conc[cell])) * way.dt;
        }
        next.conc[chemical][cell] = sum;
    }
}

// A neighbour at the same place has no direction: the published program's sum is then 0 * d / 0, which is not a number,
// and it keeps the polarity.
template <class T>
void polarize_cell(const std::vector<Near<T>>& seen, const std::vector<T>& conc, std::size_t cell, State<T>& next) {
    T gx = T(0);
    T gy = T(0);
    for (const Near<T>& near : seen) {
        if (near.norm == T(0)) return;
        gx = gx + ((conc[near.id] - conc[cell]) * near.dx) / near.norm;
        gy = gy + ((conc[near.id] - conc[cell]) * near.dy) / near.norm;
    }
    const T norm = std::sqrt(gx * gx + gy * gy);
    if (!(norm > static_cast<T>(0.0001))) return;
    next.polarity_x[cell] = gx / norm;
    next.polarity_y[cell] = gy / norm;
}

// Overlapping cells push each other apart by equal and opposite steps.
template <class T>
void collide(const std::vector<Near<T>>& seen, std::size_t cell, State<T>& next) {
    for (const Near<T>& near : seen) {
        if (!(T(0) < near.norm && near.norm < T(2))) continue;
        const T weight = static_cast<T>(0.25) - static_cast<T>(0.5) / near.norm;
        next.x[cell] = next.x[cell] + weight * near.dx;
        next.y[cell] = next.y[cell] + weight * near.dy;
    }
}

}  // namespace

template <class T>
void interact(const Interaction<T>& way, const Neighbours& neighbours, const std::vector<std::int32_t>& polarize,
              const State<T>& old, State<T>& next) {
    std::vector<Near<T>> seen;
    for (std::size_t cell = 0; cell < old.cells(); ++cell) {
        see(way, neighbours.of(cell), old, cell, seen);
        diffuse(way, seen, old, cell, next);
        if (!polarize.empty() && polarize[cell] >= 0) {
            polarize_cell(seen, old.conc[static_cast<std::size_t>(polarize[cell])], cell, next);
        }
        if (old.fixed[cell] == 0) collide(seen, cell, next);
        next.neighbours[cell] = static_cast<std::int32_t>(seen.size());
    }
}

template void interact(const Interaction<float>&, const Neighbours&, const std::vector<std::int32_t>&,
                       const State<float>&, State<float>&);
template void interact(const Interaction<double>&, const Neighbours&, const std::vector<std::int32_t>&,
                       const State<double>&, State<double>&);

}  // namespace pelage::reference
