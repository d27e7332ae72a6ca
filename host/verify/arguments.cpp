// See arguments.hpp.
#include "verify/arguments.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

namespace pelage::verify {

namespace {

// These and `more`, what lies beside each of them, and all of that with the other sign.
template <class T>
std::vector<T> special_numbers(const std::vector<double>& more) {
    using Limits = std::numeric_limits<T>;
    std::vector<T> numbers{T(0),
                           Limits::min(),
                           Limits::denorm_min(),
                           Limits::max(),
                           Limits::infinity(),
                           Limits::quiet_NaN(),
                           T(0.25),
                           T(0.5),
                           T(1),
                           T(1.5),
                           T(2),
                           T(3),
                           T(4),
                           T(5),
                           T(0.7853981633974483),
                           T(1.5707963267948966),
                           T(2.356194490192345),
                           T(3.141592653589793),
                           T(6.283185307179586),
                           T(0.6931471805599453),
                           T(0.7071067811865476),
                           T(1.4142135623730951),
                           T(2.718281828459045),
                           T(10),
                           T(88.72284),
                           T(87.33654),
                           T(103.97),
                           T(709.78),
                           T(745.13),
                           T(1e5),
                           T(1e9),
                           T(16777216)};
    for (const double number : more) numbers.push_back(static_cast<T>(number));
    const std::size_t count = numbers.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (const T end : {Limits::infinity(), -Limits::infinity()})
            numbers.push_back(std::nextafter(numbers[i], end));
    }
    const std::size_t both = numbers.size();
    for (std::size_t i = 0; i < both; ++i) numbers.push_back(-numbers[i]);
    return numbers;
}

template <class T>
T drawn_number(std::mt19937_64& engine, const std::vector<T>& special) {
    using Bits = std::conditional_t<std::is_same_v<T, float>, std::uint32_t, std::uint64_t>;
    const std::uint64_t kind = engine() % 8;
    if (kind == 0) return special[engine() % special.size()];
    if (kind == 1) {  // near one of them: where a function goes another way, it may go there too early or too late
        const T away = static_cast<T>(static_cast<double>(engine() >> 40) * 0x1p-28 - 0x1p-5);
        return special[engine() % special.size()] * (T(1) + away);
    }
    if (kind < 4) return std::bit_cast<T>(static_cast<Bits>(engine()));
    const T unit = static_cast<T>(static_cast<double>(engine() >> 40) * 0x1p-23 - 1.0);
    return std::ldexp(unit, static_cast<int>(engine() % (kind < 7 ? 8 : 40)) - (kind < 7 ? 1 : 32));
}

// Where a function of two goes another way for a pair: all pairs of them come first.
template <class T>
std::vector<T> special_alone() {
    using Limits = std::numeric_limits<T>;
    return {T(0),
            T(-0.0),
            Limits::min(),
            T(1),
            T(-1),
            Limits::max(),
            Limits::infinity(),
            -Limits::infinity(),
            Limits::quiet_NaN()};
}

}  // namespace

template <class T>
Arguments<T> drawn_arguments(std::size_t parameters, std::size_t count, std::uint64_t seed, bool narrow,
                             const std::vector<double>& more) {
    const std::vector<T> special = special_numbers<T>(more);
    const std::vector<T> alone = special_alone<T>();
    const std::size_t pairs = parameters > 1 ? alone.size() * alone.size() : 0;
    std::mt19937_64 engine(seed);
    Arguments<T> arguments;
    for (std::size_t place = 0; place < arguments.size(); ++place) {
        for (std::size_t i = 0; i < count; ++i) {
            T number = place >= parameters                        ? T(0)
                       : i < pairs && place == 0                  ? alone[i / alone.size()]
                       : i < pairs && place == 1                  ? alone[i % alone.size()]
                       : place == 0 && i - pairs < special.size() ? special[i - pairs]
                                                                  : drawn_number(engine, special);
            const T size = std::fabs(number);
            if (narrow && number != T(0) && std::isfinite(number) && (size < T(0x1p-60) || size > T(0x1p60)))
                number = T(1);
            arguments[place].push_back(number);
        }
    }
    return arguments;
}

template Arguments<float> drawn_arguments(std::size_t, std::size_t, std::uint64_t, bool, const std::vector<double>&);
template Arguments<double> drawn_arguments(std::size_t, std::size_t, std::uint64_t, bool, const std::vector<double>&);

}  // namespace pelage::verify
