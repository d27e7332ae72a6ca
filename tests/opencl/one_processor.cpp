// Threads that must share a processor after all, as on a machine that others use too.
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "support/sanitizers.hpp"

#include <sched.h>
#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <string>

using namespace pelage;

namespace {

void move_threads_to(const cpu_set_t& set) {
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
        sched_setaffinity(std::stoi(thread.path().filename().string()), sizeof set, &set);
    }
}

const char* const text =
    "define chemical U limit 10\ndefine chemical V limit 10\ndefine time_step 0.01\n"
    "use chemical U conc 4 dev 0.5 diff 5\nuse chemical V conc 4 dev 0.5 diff 1\n"
    "create matrix 80 80 wrap\nrule always react U V turing alpha 16 beta 12\nstop at 100000\n";

}  // namespace

TEST_CASE("strips that wait for each other take each other's work where they share a processor") {
    test::overlook_leaks();
    cpu_set_t all;
    REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
    OpenclOptions options;
    options.path = Path::shared;
    const auto backend = opencl_backend(options);
    if (backend->device().running_units() < 2 || backend->device().type != "cpu") {
        WARN("SKIPPED: the device does not run several work-groups of a CPU at once");
        return;
    }
    const auto tissue = backend->make_tissue(parse_experiment(text, "spots", "."));
    tissue->advance(1000);
    tissue->read();
    cpu_set_t one;
    CPU_ZERO(&one);
    for (int i = CPU_SETSIZE - 1; i >= 0 && CPU_COUNT(&one) == 0; --i) {
        if (CPU_ISSET(i, &all)) CPU_SET(i, &one);
    }
    move_threads_to(one);

    const auto start = std::chrono::steady_clock::now();
    tissue->advance(30'000);
    tissue->read();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    move_threads_to(all);
    CHECK(seconds < 8);  // 0.2 on a processor that is free; half a minute where they wait in turn
}
