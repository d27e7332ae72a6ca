// See adam.hpp.
#include "reference/learn/adam.hpp"

#include "reference/functions/quotient.hpp"
#include "reference/learn/sums.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace pelage::reference {

namespace {

template <class T>
T length_root(T square) {
    if (square < static_cast<T>(smallest_square)) return T(0);
    const functions::Pair<T> found = functions::root(functions::Pair<T>{square, T(0)});
    return found.high + found.low;
}

template <class T>
T over(T number, T divisor) {
    const functions::Pair<T> found =
        functions::quotient(functions::Pair<T>{number, T(0)}, functions::Pair<T>{divisor, T(0)});
    return found.high + found.low;
}

template <class T>
void normalise(T* slopes, std::size_t count) {
    std::array<T, sum_lanes> lanes{};
    for (std::size_t n = 0; n < count; ++n) lanes[n % sum_lanes] = std::fma(slopes[n], slopes[n], lanes[n % sum_lanes]);
    const T length = length_root(folded(lanes.data(), sum_lanes));
    const T factor = over(T(1), length + static_cast<T>(smallest_divisor));
    for (std::size_t n = 0; n < count; ++n) slopes[n] = slopes[n] * factor;
}

}  // namespace

template <class T>
void adam(const LearningShape& shape, std::vector<T> slopes, double rate, std::uint64_t count, Learned<T>& learned) {
    normalise(slopes.data(), shape.bias());
    normalise(slopes.data() + shape.bias(), shape.hidden);
    normalise(slopes.data() + shape.second(), shape.weights() - shape.second());
    const auto steps = static_cast<double>(count);
    const T length = static_cast<T>(rate / (1 - std::pow(mean_decay, steps)));
    const T scale = static_cast<T>(1 / (1 - std::pow(square_decay, steps)));
    const T fresh = static_cast<T>(1 - mean_decay), fresh_square = static_cast<T>(1 - square_decay);
    for (std::size_t n = 0; n < shape.weights(); ++n) {
        T& mean = learned.mean[n];
        T& square = learned.square[n];
        mean = std::fma(static_cast<T>(mean_decay), mean, fresh * slopes[n]);
        square = std::fma(static_cast<T>(square_decay), square, fresh_square * (slopes[n] * slopes[n]));
        const T divisor = length_root(scale * square) + static_cast<T>(smallest_divisor);
        learned.weights[n] = learned.weights[n] - over(length * mean, divisor);
    }
}

template void adam(const LearningShape&, std::vector<float>, double, std::uint64_t, Learned<float>&);
template void adam(const LearningShape&, std::vector<double>, double, std::uint64_t, Learned<double>&);

}  // namespace pelage::reference
