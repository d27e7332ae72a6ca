// How far a function's values are from the true ones, which are known to more digits.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace test {

// True values: of float in double, of double in long double.
template <class T>
using Exact = std::conditional_t<std::is_same_v<T, float>, double, long double>;

// A step of T at x, which is subnormal or larger.
template <class T>
Exact<T> step_at(Exact<T> x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    using Limits = std::numeric_limits<T>;
    return std::ldexp(Exact<T>(1), std::max(exponent, Limits::min_exponent) - Limits::digits);
}

// Distance in such steps; endless where one is NaN and the other is not, or a 0 has the wrong sign. In single precision
// what is subnormal is 0.
template <class T>
double steps_between(T found, Exact<T> exact) {
    using Limits = std::numeric_limits<T>;
    if (std::isnan(found) || std::isnan(exact)) return std::isnan(found) && std::isnan(exact) ? 0.0 : HUGE_VAL;
    if (std::isinf(static_cast<T>(exact)) && static_cast<T>(exact) == found) return 0.0;
    if (std::signbit(found) != std::signbit(exact)) return HUGE_VAL;
    const bool small = std::is_same_v<T, float> && std::fabs(exact) < Limits::min();
    if (std::isinf(exact) || exact == 0 || (small && found == 0)) {
        return found == (small ? T(0) : static_cast<T>(exact)) ? 0.0 : HUGE_VAL;
    }
    const Exact<T> beyond = std::ldexp(Exact<T>(1), Limits::max_exponent);  // where infinity would stand
    const Exact<T> value = std::isinf(found) ? std::copysign(beyond, Exact<T>(found)) : Exact<T>(found);
    return static_cast<double>(std::fabs(value - exact) /
                               step_at<T>(std::min(std::fabs(exact), Exact<T>(Limits::max()))));
}

// Functions of one argument, and how many steps each may be off.
struct OneArgument {
    std::string name;
    double bound;
    std::function<double(double)> single;
    std::function<long double(long double)> twice;
};

const std::vector<OneArgument>& functions_of_one();

struct TwoArguments {
    std::string name;
    double bound;
    std::function<double(double, double)> single;
    std::function<long double(long double, long double)> twice;
};

const std::vector<TwoArguments>& functions_of_two();

}  // namespace test
