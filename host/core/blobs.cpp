// See blobs.hpp. A spot is the product of what it is along a row and along a column.
#include "core/blobs.hpp"

#include "core/functions.hpp"
#include "core/philox.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pelage {

namespace {

constexpr double blob_reach = 8.0;  // in sigmas; beyond, a spot is below 2e-14

struct Share {  // of a spot, in one column or row
    std::size_t place = 0;
    double value = 0.0;
};

std::vector<Share> shares(std::size_t centre, std::size_t count, bool wrap, double sigma) {
    static const std::size_t exponential = function_named("exp").value();
    std::vector<Share> found;
    for (std::size_t place = 0; place < count; ++place) {
        const std::size_t straight = std::max(place, centre) - std::min(place, centre);
        const auto far = static_cast<double>(wrap ? std::min(straight, count - straight) : straight);
        if (far > blob_reach * sigma) continue;
        double value = -0.5 * ((far / sigma) * (far / sigma));
        const double* column = &value;
        compute_function(exponential, &column, 1, &value);
        found.push_back({place, value});
    }
    return found;
}

std::size_t drawn_place(std::uint32_t word, std::size_t count) {
    return static_cast<std::size_t>((std::uint64_t{word} * count) >> 32);
}

}  // namespace

std::vector<double> blob_values(const BlobField& blobs, const Lattice& lattice, std::int64_t seed, std::size_t place) {
    std::vector<double> values(lattice.columns * lattice.rows, 0.0);
    const bool wrap = lattice.boundary == Boundary::wrap;
    for (std::size_t blob = 0; blob < blobs.count; ++blob) {
        const auto words = counted_words(blob, 0, place, purpose::field, seed);
        const auto across = shares(drawn_place(words[0], lattice.columns), lattice.columns, wrap, blobs.sigma);
        const auto up = shares(drawn_place(words[1], lattice.rows), lattice.rows, wrap, blobs.sigma);
        for (const Share& row : up) {
            for (const Share& column : across)
                values[row.place * lattice.columns + column.place] += row.value * column.value;
        }
    }
    return values;
}

}  // namespace pelage
