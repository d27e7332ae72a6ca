// Every float there is, for each function of one argument. Compiled for the machine at hand: minutes become seconds.
#include "core/subnormal.hpp"
#include "reference_functions.hpp"
#include "support/function_errors.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

using namespace pelage;

namespace {

struct Worst {
    double steps = 0;
    float at = 0;

    void take(double found, float x) {
        if (found > steps) *this = {found, x};
    }
};

constexpr std::uint64_t block = 1 << 16;

// A float's step at the float next to the true value, where both are plain numbers; else as steps_between says.
double steps_off(float found, double exact) {
    const double size = std::fabs(exact);
    if (!(size > 0x1p-125 && size < 0x1p127)) return test::steps_between(found, exact);
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(exact) >> 52 & 0x7ff;
    return std::fabs(found - exact) * std::bit_cast<double>((2046 + 23 - exponent) << 52);
}

// A share of all floats: one block in `of`, from the `first` one on.
template <class Function>
Worst worst_of(const Function& function, double (*exact)(double), std::uint64_t first, std::uint64_t of) {
    Worst worst;
    std::vector<float> found(block);
    for (std::uint64_t begin = first * block; begin < std::uint64_t{1} << 32; begin += of * block) {
        {
            const SubnormalsAreZero scope;
            for (std::uint64_t i = 0; i < block; ++i)
                found[i] = function(std::bit_cast<float>(static_cast<std::uint32_t>(begin + i)));
        }
        for (std::uint64_t i = 0; i < block; ++i) {
            const float x = std::bit_cast<float>(static_cast<std::uint32_t>(begin + i));
            const float taken = std::fabs(x) < 0x1p-126f ? std::copysign(0.0f, x) : x;
            worst.take(steps_off(found[i], exact(taken)), x);
        }
    }
    return worst;
}

template <class Function>
void check_all(const std::string& name, const Function& function, double (*exact)(double)) {
    const std::uint64_t threads = std::max(1u, std::thread::hardware_concurrency());
    std::vector<Worst> parts(threads);
    std::vector<std::thread> workers;
    for (std::uint64_t i = 0; i < threads; ++i)
        workers.emplace_back([&, i] { parts[i] = worst_of(function, exact, i, threads); });
    for (std::thread& worker : workers) worker.join();
    Worst worst;
    for (const Worst& part : parts) worst.take(part.steps, part.at);
    std::cout << name << ": at most " << worst.steps << " steps, at " << worst.at << "\n";
    const auto& all = test::functions_of_one();
    const auto known = std::ranges::find(all, name, &test::OneArgument::name);
    REQUIRE(known != all.end());
    INFO(name << " at " << worst.at);
    CHECK(worst.steps <= known->bound);
    CHECK(worst.steps > 0.5);
}

double sigmoid(double x) { return 1 / (1 + std::exp(-x)); }

}  // namespace

#define PELAGE_ALL(name, exact)                                                          \
    TEST_CASE("every float: " #name) {                                                   \
        check_all(                                                                       \
            #name, [](float x) { return reference::functions::name<float>(x); }, exact); \
    }

PELAGE_ALL(exp, std::exp)
PELAGE_ALL(log, std::log)
PELAGE_ALL(sin, std::sin)
PELAGE_ALL(cos, std::cos)
PELAGE_ALL(tan, std::tan)
PELAGE_ALL(asin, std::asin)
PELAGE_ALL(acos, std::acos)
PELAGE_ALL(atan, std::atan)
PELAGE_ALL(sinh, std::sinh)
PELAGE_ALL(cosh, std::cosh)
PELAGE_ALL(tanh, std::tanh)
PELAGE_ALL(sigmoid, sigmoid)
