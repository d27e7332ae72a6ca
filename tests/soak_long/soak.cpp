// New random experiments for as long as PELAGE_SOAK_MINUTES says (30 unless set), from seed PELAGE_SOAK_SEED on (the
// clock unless set): equal on both backends, and no memory lost on the way.
#include "soak_long/memory.hpp"
#include "support/random_runs.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

using namespace pelage::verify;

namespace {

using Clock = std::chrono::steady_clock;

std::optional<double> variable(const char* name) {
    const char* text = std::getenv(name);
    if (text == nullptr || *text == '\0') return std::nullopt;
    return std::strtod(text, nullptr);
}

std::uint64_t base_seed() {
    if (const auto given = variable("PELAGE_SOAK_SEED")) return static_cast<std::uint64_t>(*given);
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(now / std::chrono::seconds(1)) * 100000u;
}

// Mostly small, so that compiling takes the time; now and then large or long.
RandomLimits limits_of(std::uint64_t seed) {
    RandomLimits limits;
    if (seed % 16 == 7) limits.cells = 6000;
    if (seed % 16 == 15) limits.iterations = 400;
    return limits;
}

}  // namespace

TEST_CASE("Random experiments run alike for a long time") {
    const double minutes = variable("PELAGE_SOAK_MINUTES").value_or(30.0);
    const auto start = Clock::now();
    const auto passed = [&] { return std::chrono::duration<double, std::ratio<60>>(Clock::now() - start).count(); };
    const std::uint64_t base = base_seed();
    test::RandomRuns runs(false);
    std::uint64_t seed = base;
    std::uint64_t half_seed = base;
    double half_resident = 0.0;
    double told = 0.0;

    std::cout << fmt::format("PELAGE_SOAK_SEED={}\n", base);
    while (passed() < minutes) {
        const std::string difference = runs.check(seed, limits_of(seed), seed % 8 == 7 ? 2 : 15);
        INFO(difference);
        CHECK(difference.empty());
        ++seed;
        if (half_resident == 0.0 && passed() >= minutes / 2) {
            half_resident = test::resident();
            half_seed = seed;
        }
        if (passed() < told && passed() < minutes) continue;
        std::cout << fmt::format("{:6.2f} min: {} experiments, {} runs ({} finite), {} cells, {:.1f} MiB\n", passed(),
                                 seed - base, runs.runs(), runs.finite(), runs.cells(), test::resident())
                  << std::flush;
        told = passed() + minutes / 30.0;
    }
    const double grown = test::resident() - half_resident;
    const auto experiments = static_cast<double>(seed - half_seed);

    CHECK(4 * runs.finite() > 3 * runs.runs());
    INFO(fmt::format("{:.1f} MiB more after {} experiments of the second half", grown, experiments));
    // PoCL keeps about half a MiB of the programs that one experiment needs; see the other test for what we keep.
    CHECK(grown < 64.0 + 1.5 * experiments);
}

TEST_CASE("Experiments that are run again take no more memory") {
    constexpr std::size_t rounds = 12;
    constexpr std::uint64_t first = 5000, count = 8;
    test::RandomRuns runs(true);
    double before = 0.0;
    std::size_t runs_before = 0;

    for (std::size_t round = 0; round < rounds; ++round) {
        for (std::uint64_t seed = first; seed < first + count; ++seed) {
            RandomLimits limits;
            limits.cells = 9000;  // an array that is not given back weighs more than what is allowed
            limits.iterations = 12;
            limits.phases = false;
            const std::string difference = runs.check(seed, limits, 3);
            INFO(difference);
            CHECK(difference.empty());
        }
        if (round + 1 == rounds / 2) {
            before = test::allocated();
            runs_before = runs.runs();
        }
        std::cout << fmt::format("round {}: {} runs, {:.2f} MiB allocated, {:.2f} MiB resident\n", round, runs.runs(),
                                 test::allocated(), test::resident())
                  << std::flush;
    }
    const double a_run = 1024.0 * (test::allocated() - before) / static_cast<double>(runs.runs() - runs_before);

    INFO(fmt::format("{:.2f} KiB more with each run", a_run));
    CHECK(a_run < 16.0);  // PoCL keeps some 5 KiB of every tissue's programs
}
