// See growth.hpp.
#include "core/growth.hpp"

#include "core/philox.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pelage {

namespace {

class Draws {  // one line's or one permutation's stream of words
public:
    Draws(std::int64_t seed, std::uint64_t iteration, std::size_t rule, std::size_t nth)
        : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(static_cast<std::uint64_t>(seed) >> 32)},
          counter_{0, static_cast<std::uint32_t>(iteration), static_cast<std::uint32_t>(rule),
                   static_cast<std::uint32_t>(purpose::expansion + 16 * nth)} {}

    std::uint32_t word(std::size_t line) {
        counter_[0] = static_cast<std::uint32_t>(line);
        return philox4x32_10(counter_, key_)[0];
    }

private:
    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_;
};

std::size_t below(std::uint32_t word, std::size_t count) {
    return static_cast<std::size_t>((std::uint64_t{word} * count) >> 32);
}

double normal_below(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

double weight(Distribution distribution, std::size_t place, std::size_t places) {
    const double p = static_cast<double>(place);
    const double n = static_cast<double>(places);
    switch (distribution) {
        case Distribution::triangular:
            return std::min(p + 1.0, n - p);
        case Distribution::normal: {
            const double low = place == 0 ? 0.0 : normal_below((p - n / 2) / (n / 6));
            const double high = place + 1 == places ? 1.0 : normal_below((p + 1 - n / 2) / (n / 6));
            return high - low;
        }
        default:
            return 1.0;
    }
}

std::vector<double> cumulative_weights(const Expand& growth, bool column, std::size_t places) {
    std::vector<double> sums(places);
    double sum = 0.0;
    for (std::size_t place = 0; place < places; ++place) {
        const double at = static_cast<double>(place) / static_cast<double>(places);
        const bool in_band = growth.band_rows == !column && at >= growth.band_low && at <= growth.band_high;
        sum += weight(growth.distribution, place, places) * (in_band ? growth.band_weight : 1.0);
        sums[place] = sum;
    }
    return sums;
}

// Permutations of all places follow one another until every line has its pick.
std::vector<std::uint32_t> shuffled_picks(Draws& draws, std::size_t lines, std::size_t places) {
    std::vector<std::uint32_t> picks;
    picks.reserve(lines);
    std::vector<std::uint32_t> order(places);
    for (std::size_t line = 0; line < lines; ++line) {
        const std::size_t dealt = line % places;
        if (dealt == 0) std::iota(order.begin(), order.end(), 0u);
        std::swap(order[dealt], order[dealt + below(draws.word(line), places - dealt)]);
        picks.push_back(order[dealt]);
    }
    return picks;
}

}  // namespace

Insertion draw_insertion(const Expand& growth, bool column, std::size_t columns, std::size_t rows, std::int64_t seed,
                         std::uint64_t iteration, std::size_t rule, std::size_t nth) {
    const std::size_t lines = column ? rows : columns;
    const std::size_t places = column ? columns : rows;
    Draws draws(seed, iteration, rule, nth);
    Insertion insertion{column, {}};
    if (growth.distribution == Distribution::shuffled) {
        insertion.picks = shuffled_picks(draws, lines, places);
        return insertion;
    }
    const std::vector<double> sums = cumulative_weights(growth, column, places);
    for (std::size_t line = 0; line < lines; ++line) {
        const double target = draws.word(line) * 0x1p-32 * sums.back();
        const auto found = std::upper_bound(sums.begin(), sums.end(), target);
        const auto place = static_cast<std::uint32_t>(found - sums.begin());
        insertion.picks.push_back(std::min(place, static_cast<std::uint32_t>(places - 1)));
    }
    return insertion;
}

}  // namespace pelage
