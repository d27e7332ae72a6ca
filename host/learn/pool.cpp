// See pool.hpp.
#include "learn/pool.hpp"

#include "core/blobs.hpp"
#include "learn/draws.hpp"

#include <algorithm>
#include <cmath>

namespace pelage::learn {

namespace {

constexpr double spot_height = 0.145, spot_sigma = 3.0;
constexpr std::size_t cells_a_spot = 200;
constexpr float largest_number = 100.0f;  // of a state that is given back

}  // namespace

std::vector<float> seed_state(const LearningShape& shape, std::int64_t seed, std::size_t which) {
    Lattice torus;
    torus.columns = torus.rows = shape.side;
    torus.boundary = Boundary::wrap;
    const BlobField spots{std::max<std::size_t>(1, shape.cells() / cells_a_spot), spot_sigma};
    const std::vector<double> values = blob_values(spots, torus, seed, which);
    std::vector<float> state(shape.sample(), 0.0f);
    for (std::size_t colour = 0; colour < picture_colours; ++colour) {
        for (std::size_t cell = 0; cell < shape.cells(); ++cell)
            state[colour * shape.cells() + cell] = static_cast<float>(spot_height * values[cell]);
    }
    return state;
}

std::vector<std::size_t> Pool::drawn_places(std::uint64_t step) const {
    std::vector<std::size_t> places;
    for (std::size_t draw = 0; places.size() < shape_.batch; ++draw) {
        const std::size_t place = one_of(drawn(seed_, Draw::places, draw, step)[0], size_);
        if (std::ranges::find(places, place) == places.end()) places.push_back(place);
    }
    return places;
}

std::vector<float> Pool::at(std::size_t place) const {
    const auto found = kept_.find(place);
    return found == kept_.end() ? seed_state(shape_, seed_, place) : found->second;
}

std::vector<float> Pool::fresh(std::uint64_t step) const {
    return seed_state(shape_, seed_, size_ + static_cast<std::size_t>(step));
}

void Pool::put(std::size_t place, const float* state) {
    const auto sound = [](float number) { return std::fabs(number) <= largest_number; };
    if (std::all_of(state, state + shape_.sample(), sound))
        kept_[place].assign(state, state + shape_.sample());
    else
        forget(place);
}

}  // namespace pelage::learn
