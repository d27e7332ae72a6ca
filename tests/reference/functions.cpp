// Elementary functions of the reference: how far they are from the true values, and their special values.
#include "core/functions.hpp"
#include "core/subnormal.hpp"
#include "reference/functions/quick_sigmoid.hpp"
#include "reference/rules/functions.hpp"
#include "support/function_errors.hpp"
#include "verify/arguments.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace pelage;
using test::steps_between;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class T>
T value(const std::string& name, T a, T b = T(0), T c = T(0)) {
    const std::array<T, 3> arguments{a, b, c};
    const SubnormalsAreZero scope(sizeof(T) == sizeof(float));
    return reference::apply_function(*function_named(name), arguments.data());
}

// As a function in single precision takes it.
float without_subnormals(float x) { return std::fabs(x) < 0x1p-126f ? std::copysign(0.0f, x) : x; }

// Both precisions give `expected`, with the sign of a 0.
void check_value(const std::string& name, double expected, double a, double b = 0) {
    INFO(name << "(" << a << ", " << b << ")");
    const double twice = value<double>(name, a, b);
    const double single = value<float>(name, static_cast<float>(a), static_cast<float>(b));
    for (const double found : {twice, single}) {
        if (std::isnan(expected)) {
            CHECK(std::isnan(found));
            continue;
        }
        CHECK(found == Approx(expected).epsilon(1e-6));
        CHECK(std::signbit(found) == std::signbit(expected));
    }
}

template <class T>
std::vector<T> column(std::size_t function, const verify::Arguments<T>& arguments, bool flush) {
    const SubnormalsAreZero scope(flush);
    const std::array<const T*, 3> columns{arguments[0].data(), arguments[1].data(), arguments[2].data()};
    std::vector<T> found(arguments[0].size());
    compute_function(function, columns.data(), found.size(), found.data());
    return found;
}

// Angles that are as near to multiples of pi/2 as doubles are, or far out.
const std::vector<double> critical{0x1.6ac5b262ca1ffp+849,
                                   0x1.0f0cf064dd592p+73,
                                   0x1.921fb54442d18p+1,
                                   0x1.921fb54442d18p+20,
                                   4194303.5,
                                   4194304.5,
                                   1e22,
                                   0x1.fffffffffffffp+1023};

}  // namespace

TEST_CASE("functions of one float are within their bounds") {
    for (const test::OneArgument& function : test::functions_of_one()) {
        const std::size_t index = *function_named(function.name);
        verify::Arguments<float> arguments = verify::drawn_arguments<float>(1, 20'000, 1, false);
        for (std::uint64_t bits = 0; bits < (std::uint64_t{1} << 32); bits += 100'003)
            arguments[0].push_back(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
        for (auto& other : {&arguments[1], &arguments[2]}) other->resize(arguments[0].size());
        const std::vector<float> found = column(index, arguments, true);
        double worst = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const float x = without_subnormals(arguments[0][i]);
            const double off = steps_between(found[i], function.single(x));
            INFO(function.name << "(" << x << ") is " << found[i] << ", not " << function.single(x));
            worst = std::max(worst, off);
            if (off > function.bound) CHECK(off <= function.bound);
        }
        INFO(function.name);
        CHECK(worst > 0.4);  // so much comes of rounding alone
        CHECK(worst <= function.bound);
    }
}

TEST_CASE("functions of one double are within their bounds") {
    for (const test::OneArgument& function : test::functions_of_one()) {
        verify::Arguments<double> arguments = verify::drawn_arguments<double>(1, 20'000, 1, false);
        for (const double x : critical) arguments[0].push_back(x);
        for (auto& other : {&arguments[1], &arguments[2]}) other->resize(arguments[0].size());
        const std::vector<double> found = column(*function_named(function.name), arguments, false);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double off = steps_between(found[i], function.twice(arguments[0][i]));
            INFO(function.name << "(" << arguments[0][i] << ") is " << found[i]);
            if (off > function.bound) CHECK(off <= function.bound);
        }
        CHECK(found.size() > 20'000);
    }
}

TEST_CASE("functions of two numbers are within their bounds") {
    for (const test::TwoArguments& function : test::functions_of_two()) {
        const std::size_t index = *function_named(function.name);
        const auto singles = verify::drawn_arguments<float>(2, 50'000, 2, false);
        const std::vector<float> single = column(index, singles, true);
        const auto doubles = verify::drawn_arguments<double>(2, 50'000, 2, false);
        const std::vector<double> twice = column(index, doubles, false);
        for (std::size_t i = 0; i < single.size(); ++i) {
            const float a = without_subnormals(singles[0][i]), b = without_subnormals(singles[1][i]);
            INFO(function.name << "(" << a << ", " << b << ") is " << single[i]);
            INFO(function.name << "(" << doubles[0][i] << ", " << doubles[1][i] << ") is " << twice[i]);
            const double off = steps_between(single[i], function.single(a, b));
            const double off_twice = steps_between(twice[i], function.twice(doubles[0][i], doubles[1][i]));
            if (off > function.bound) CHECK(off <= function.bound);
            if (off_twice > function.bound) CHECK(off_twice <= function.bound);
        }
    }
}

TEST_CASE("powers whose results fill the range of numbers are within their bounds") {
    const test::TwoArguments& power = test::functions_of_two().front();
    for (const double base : {1.00001, 1.5, 0.3, 3e-30, 7e20, 0.9999999}) {
        for (int i = -400; i <= 400; ++i) {
            const double exponent = 0.25 * i / std::log(base);
            const auto x = static_cast<float>(base), y = static_cast<float>(exponent);
            INFO(base << "^" << exponent);
            CHECK(steps_between(value("pow", x, y), power.single(x, y)) <= power.bound);
            const double far = exponent * 7.2;
            CHECK(steps_between(value("pow", base, far), power.twice(base, far)) <= power.bound);
        }
    }
}

TEST_CASE("functions do not depend on what the processor does with subnormal numbers") {
    for (std::size_t index = 0; index < function_table().size(); ++index) {
        const FunctionFacts& function = function_table()[index];
        if (function.name == "mod" || function.name == "mix" || function.name == "smoothstep")
            continue;  // plain arithmetic
        const auto arguments = verify::drawn_arguments<float>(function.parameters.size(), 20'000, 3, false);
        const std::vector<float> flushing = column(index, arguments, true);
        const std::vector<float> keeping = column(index, arguments, false);
        for (std::size_t i = 0; i < flushing.size(); ++i) {
            if (std::isnan(flushing[i]) && std::isnan(keeping[i])) continue;
            if (std::bit_cast<std::uint32_t>(flushing[i]) == std::bit_cast<std::uint32_t>(keeping[i])) continue;
            INFO(function.name << "(" << arguments[0][i] << ", " << arguments[1][i] << ")");
            CHECK(flushing[i] == keeping[i]);
        }
    }
}

TEST_CASE("the networks' quick sigmoid is within 4 units of the last place from -40 upward") {
    double worst_single = 0, worst_double = 0;
    for (int i = -400'000; i <= 400'000; ++i) {
        const float x = static_cast<float>(i) * 1.0e-4f;
        const long double single = 1 / (1 + std::exp(-static_cast<long double>(x)));
        const double ulp = std::nextafter(static_cast<float>(single), 2.0f) - static_cast<float>(single);
        worst_single = std::max(worst_single,
                                static_cast<double>(std::abs(reference::functions::quick_sigmoid(x) - single)) / ulp);
        const double twice = static_cast<double>(i) * 1.0e-4;
        const long double wide = 1 / (1 + std::exp(-static_cast<long double>(twice)));
        const double fine = std::nextafter(static_cast<double>(wide), 2.0) - static_cast<double>(wide);
        worst_double = std::max(
            worst_double, static_cast<double>(std::abs(reference::functions::quick_sigmoid(twice) - wide)) / fine);
    }
    CHECK(worst_single < 4);
    CHECK(worst_double < 4);
    CHECK(worst_single > 0.5);
    CHECK(reference::functions::quick_sigmoid(-1.0e30f) < 5e-18f);
    CHECK(reference::functions::quick_sigmoid(1.0e30f) == 1.0f);
}

TEST_CASE("special values are those of C") {
    for (const char* name :
         {"exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "sigmoid"})
        check_value(name, not_a_number, not_a_number);
    for (const char* name : {"sin", "tan", "asin", "atan", "sinh", "tanh", "floor", "ceil", "round", "sqrt"}) {
        check_value(name, 0.0, 0.0);
        check_value(name, -0.0, -0.0);
    }
    for (const char* name : {"sin", "cos", "tan", "asin", "acos"}) check_value(name, not_a_number, endless);
    for (const char* name : {"log", "sqrt", "asin", "acos"}) check_value(name, not_a_number, -1.5);
    check_value("exp", 0.0, -endless);
    check_value("exp", endless, endless);
    check_value("exp", 1, -0.0);
    check_value("log", -endless, -0.0);
    check_value("log", 0.0, 1);
    check_value("log", endless, endless);
    check_value("acos", 0.0, 1);
    check_value("atan", 1.5707963267948966, endless);
    check_value("tanh", -1, -endless);
    check_value("sinh", -endless, -endless);
    check_value("cosh", endless, -endless);
    check_value("sigmoid", 0.5, 0);
    check_value("sigmoid", 0.0, -endless);
    check_value("sigmoid", 1, endless);
}

TEST_CASE("atan2 and hypot have C's special values") {
    const double pi = 3.141592653589793;
    for (const double sign : {1.0, -1.0}) {
        check_value("atan2", sign * pi, sign * 0.0, -0.0);
        check_value("atan2", sign * 0.0, sign * 0.0, 0.0);
        check_value("atan2", sign * pi, sign * 0.0, -2);
        check_value("atan2", sign * 0.0, sign * 0.0, 2);
        check_value("atan2", sign * pi / 2, sign * 2, 0.0);
        check_value("atan2", sign * pi / 2, sign * 2, -0.0);
        check_value("atan2", sign * pi, sign * 2, -endless);
        check_value("atan2", sign * 0.0, sign * 2, endless);
        check_value("atan2", sign * pi / 2, sign * endless, 2);
        check_value("atan2", sign * 0.75 * pi, sign * endless, -endless);
        check_value("atan2", sign * 0.25 * pi, sign * endless, endless);
        check_value("hypot", endless, sign * endless, not_a_number);
        check_value("hypot", endless, not_a_number, sign * endless);
    }
    check_value("atan2", not_a_number, not_a_number, 1);
    check_value("atan2", not_a_number, 1, not_a_number);
    check_value("hypot", 5, -3, 4);
    check_value("hypot", 0.0, -0.0, 0.0);
    check_value("hypot", 3e38, 1.8e38, 2.4e38);
}

TEST_CASE("pow has C's special values") {
    for (const double sign : {1.0, -1.0}) {
        check_value("pow", sign * 0.0, sign * 0.0, 3);
        check_value("pow", sign * endless, sign * 0.0, -3);
        check_value("pow", 0.0, sign * 0.0, 2.5);
        check_value("pow", endless, sign * 0.0, -2);
        check_value("pow", endless, sign * 0.0, -endless);
        check_value("pow", 1, -1, sign * endless);
        check_value("pow", 1, 1, sign * not_a_number);
        check_value("pow", 1, not_a_number, sign * 0.0);
        check_value("pow", 0.0, sign * 0.5, endless);
        check_value("pow", endless, sign * 0.5, -endless);
        check_value("pow", endless, sign * 2, endless);
        check_value("pow", 0.0, sign * 2, -endless);
        check_value("pow", sign * endless, sign * endless, 3);
        check_value("pow", endless, sign * endless, 2);
        check_value("pow", sign * 0.0, sign * endless, -3);
        check_value("pow", 0.0, sign * endless, -2.5);
        check_value("pow", sign * 8, sign * 2, 3);
    }
    check_value("pow", not_a_number, -2, 0.5);
    check_value("pow", not_a_number, not_a_number, 1);
    check_value("pow", not_a_number, 2, not_a_number);
}

TEST_CASE("the exact functions are what the language's page says") {
    check_value("round", 3, 2.5);
    check_value("round", -3, -2.5);
    check_value("round", 0.0, 0.49999997);
    check_value("floor", -3, -2.5);
    check_value("ceil", -2, -2.5);
    check_value("mod", 1.5, -2.5, 4);
    check_value("mod", -1.5, 2.5, -4);
    check_value("abs", 2.5, -2.5);
    check_value("min", -1, 2, -1);
    check_value("max", 2, 2, -1);
    check_value("min", not_a_number, not_a_number, 1);
    check_value("max", 1, 1, not_a_number);
    check_value("step", 1, 2, 2);
    check_value("step", 0, 2, 1.9);
    CHECK(value("clamp", 7.0, 1.0, 5.0) == 5.0);
    CHECK(value("clamp", -7.0f, 1.0f, 5.0f) == 1.0f);
    CHECK(value("mix", 2.0, 6.0, 0.25) == 3.0);
    CHECK(value("smoothstep", 1.0f, 3.0f, 2.0f) == 0.5f);
    CHECK(value("smoothstep", 1.0, 3.0, 9.0) == 1.0);
}
