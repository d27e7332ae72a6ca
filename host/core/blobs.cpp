// See blobs.hpp. On a grid a spot is the product of what it is along a row, along a column and through the layers.
#include "core/blobs.hpp"

#include "core/functions.hpp"
#include "core/philox.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace pelage {

namespace {

constexpr double blob_reach = 8.0;  // in sigmas; beyond, a spot is below 2e-14

struct Share {  // of a spot, in one column, row or layer
    std::size_t place = 0;
    double value = 0.0;
};

double height_at(double far, double sigma) {
    static const std::size_t exponential = function_named("exp").value();
    double value = -0.5 * ((far / sigma) * (far / sigma));
    const double* column = &value;
    compute_function(exponential, &column, 1, &value);
    return value;
}

std::vector<Share> shares(std::size_t centre, std::size_t count, bool wrap, double sigma) {
    std::vector<Share> found;
    for (std::size_t place = 0; place < count; ++place) {
        const std::size_t straight = std::max(place, centre) - std::min(place, centre);
        const auto far = static_cast<double>(wrap ? std::min(straight, count - straight) : straight);
        if (far <= blob_reach * sigma) found.push_back({place, height_at(far, sigma)});
    }
    return found;
}

std::size_t drawn_place(std::uint32_t word, std::size_t count) {
    return static_cast<std::size_t>((std::uint64_t{word} * count) >> 32);
}

struct Box {
    std::size_t columns = 0, rows = 0, layers = 1;
    bool wrap = false;
};

std::vector<double> values_in(const BlobField& blobs, const Box& box, std::int64_t seed, std::size_t place) {
    std::vector<double> values(box.columns * box.rows * box.layers, 0.0);
    for (std::size_t blob = 0; blob < blobs.count; ++blob) {
        const auto words = counted_words(blob, 0, place, purpose::field, seed);
        const auto along = [&](std::size_t axis, std::size_t count) {
            return shares(drawn_place(words[axis], count), count, box.wrap, blobs.sigma);
        };
        const auto across = along(0, box.columns), up = along(1, box.rows), deep = along(2, box.layers);
        for (const Share& layer : deep) {
            for (const Share& row : up) {
                double* line = values.data() + (layer.place * box.rows + row.place) * box.columns;
                for (const Share& column : across) line[column.place] += layer.value * row.value * column.value;
            }
        }
    }
    return values;
}

}  // namespace

std::vector<double> blob_values(const BlobField& blobs, const Lattice& lattice, std::int64_t seed, std::size_t place) {
    return values_in(blobs, {lattice.columns, lattice.rows, 1, lattice.boundary == Boundary::wrap}, seed, place);
}

std::vector<double> blob_values(const BlobField& blobs, const Volume& volume, std::int64_t seed, std::size_t place) {
    return values_in(blobs, {volume.columns, volume.rows, volume.layers, volume.boundary == Boundary::wrap}, seed,
                     place);
}

std::vector<double> blob_values(const BlobField& blobs, const MeshSurface& surface, std::int64_t seed,
                                std::size_t place) {
    const std::vector<Point>& vertices = surface.mesh.vertices;
    std::vector<std::uint32_t> along(vertices.size());  // from left to right: few need to be looked at for a spot
    std::iota(along.begin(), along.end(), 0u);
    const auto left = [&](std::uint32_t vertex) { return vertices[vertex][0]; };
    std::ranges::sort(along, {}, left);
    const double reach = blob_reach * blobs.sigma;
    std::vector<double> values(vertices.size(), 0.0);
    for (std::size_t blob = 0; blob < blobs.count; ++blob) {
        const std::uint32_t word = counted_words(blob, 0, place, purpose::field, seed)[0];
        const Point& centre = vertices[drawn_place(word, vertices.size())];
        for (auto at = std::ranges::lower_bound(along, centre[0] - reach, {}, left);
             at != along.end() && left(*at) <= centre[0] + reach; ++at) {
            const double far = length(vertices[*at] - centre);
            if (far <= reach) values[*at] += height_at(far, blobs.sigma);
        }
    }
    return values;
}

}  // namespace pelage
