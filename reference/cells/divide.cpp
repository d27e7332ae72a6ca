// See divide.hpp.
#include "reference/cells/divide.hpp"

#include "core/error.hpp"
#include "core/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pelage::reference {

namespace {

// c[0] + z * (c[1] + z * (...)), each constant a float.
template <class T, std::size_t N>
T horner(T z, const float (&c)[N]) {
    T sum = static_cast<T>(c[N - 1]);
    for (std::size_t i = N - 1; i-- > 0;) sum = static_cast<T>(c[i]) + z * sum;
    return sum;
}

template <class T>
std::array<T, 2> direction(const Division& division, const State<T>& old) {
    const auto [sine, cosine] = sine_cosine(static_cast<T>(division.degrees));
    T px = old.polarity_x[division.cell];
    T py = old.polarity_y[division.cell];
    if (px == T(0) && py == T(0)) {
        px = T(1);
    } else {
        const T norm = std::sqrt(px * px + py * py);
        px = px / norm;
        py = py / norm;
    }
    return {px * cosine - py * sine, px * sine + py * cosine};
}

}  // namespace

template <class T>
std::array<T, 2> sine_cosine(T degrees) {
    constexpr float sine_terms[] = {3.14159265f, -5.16771278f, 2.55016404f, -0.59926453f, 0.08214589f};
    constexpr float cosine_terms[] = {1.0f, -4.93480220f, 4.05871213f, -1.33526277f, 0.23533063f, -0.02580689f};
    const T half_turns = degrees / T(180);
    const T t = half_turns - T(2) * std::rint(half_turns * T(0.5));  // -1 .. 1
    const T s = std::fabs(t);
    const T quarters = s * T(2) + T(0.5);
    const int q = quarters < T(1) ? 0 : quarters < T(2) ? 1 : 2;
    const T r = s - T(0.5) * static_cast<T>(q);
    const T z = r * r;
    const T sn = r * horner(z, sine_terms);
    const T cs = horner(z, cosine_terms);
    const T sine = q == 0 ? sn : q == 1 ? cs : -sn;
    const T cosine = q == 0 ? cs : q == 1 ? -sn : -cs;
    return {t < T(0) ? -sine : sine, cosine};
}

template <class T>
void judge_divisions(std::vector<Division>& divisions, const State<T>& old, std::size_t division_limit) {
    if (division_limit != 0) {
        std::erase_if(divisions, [&](const Division& division) {
            return static_cast<std::size_t>(old.neighbours[division.cell]) > division_limit;
        });
    }
    std::ranges::sort(divisions, {}, [](const Division& division) { return std::tuple(division.cell, division.rule); });
}

template <class T>
void append_children(const std::vector<Division>& divisions, std::uint64_t iteration, const State<T>& old,
                     State<T>& next) {
    if (next.cells() + divisions.size() > largest_cell_count) {
        throw Error(fmt::format("growth past {} cells at iteration {}; no more can be addressed", largest_cell_count,
                                iteration));
    }
    const auto copy = [](const std::vector<std::vector<T>>& from, std::size_t cell, std::vector<std::vector<T>>& to) {
        for (std::size_t i = 0; i < from.size(); ++i) to[i].push_back(from[i][cell]);
    };
    for (const Division& division : divisions) {
        const auto [ex, ey] = direction(division, old);
        copy(old.conc, division.cell, next.conc);
        copy(old.diff, division.cell, next.diff);
        copy(old.mappings, division.cell, next.mappings);
        next.x.push_back(old.x[division.cell] + ex);
        next.y.push_back(old.y[division.cell] + ey);
        next.polarity_x.push_back(ex);
        next.polarity_y.push_back(ey);
        next.birth.push_back(static_cast<std::uint32_t>(iteration + 1));
        next.neighbours.push_back(0);
        next.fixed.push_back(0);
    }
}

template std::array<float, 2> sine_cosine(float);
template std::array<double, 2> sine_cosine(double);
template void judge_divisions(std::vector<Division>&, const State<float>&, std::size_t);
template void judge_divisions(std::vector<Division>&, const State<double>&, std::size_t);
template void append_children(const std::vector<Division>&, std::uint64_t, const State<float>&, State<float>&);
template void append_children(const std::vector<Division>&, std::uint64_t, const State<double>&, State<double>&);

}  // namespace pelage::reference
