// What a schedule makes of a program: every group and every work-item is there once, in another order.
#include "opencl/device/launch.hpp"
#include "opencl/device/schedule.hpp"
#include "opencl/device/session.hpp"
#include "support/variable.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace pelage;

namespace {

// who[n]: 1 + how many work-items have come before the one with the global number n. before[n]: that of its neighbour
// in the group, which it does not wait for; 0 where it has not come yet.
const char* const kernel_text = R"(
kernel void roll(volatile global int* count, volatile global int* who, global int* before, int columns) {
    const int number = (int)get_global_id(1) * columns + (int)get_global_id(0);
    who[number] += 1 + atomic_inc(count);
    before[number] = get_local_id(0) > 0 ? who[number - 1] : -1;
}
)";

struct Roll {
    std::vector<cl_int> who, before;
};

Roll roll(std::size_t columns, std::size_t rows, std::size_t group) {
    OpenclOptions options;
    options.use_cache = false;
    const Session session(select_device(), options);
    cl::Kernel kernel(session.build(kernel_text), "roll");
    const std::size_t cells = columns * rows;
    const cl::Buffer count = session.buffer(sizeof(cl_int), "count");
    const cl::Buffer who = session.buffer(cells * sizeof(cl_int), "who");
    const cl::Buffer before = session.buffer(cells * sizeof(cl_int), "before");
    Roll all{std::vector<cl_int>(cells), std::vector<cl_int>(cells)};
    const cl_int none = 0;
    session.queue().enqueueWriteBuffer(count, CL_TRUE, 0, sizeof none, &none);
    session.queue().enqueueWriteBuffer(who, CL_TRUE, 0, cells * sizeof(cl_int), all.who.data());
    kernel.setArg(0, count);
    kernel.setArg(1, who);
    kernel.setArg(2, before);
    kernel.setArg(3, static_cast<cl_int>(columns));
    session.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(columns, rows), cl::NDRange(group, 1));
    session.queue().enqueueReadBuffer(who, CL_TRUE, 0, cells * sizeof(cl_int), all.who.data());
    session.queue().enqueueReadBuffer(before, CL_TRUE, 0, cells * sizeof(cl_int), all.before.data());
    return all;
}

}  // namespace

TEST_CASE("every work-item of a launch comes once in every order, whatever the numbers of groups and items") {
    const char* const order = GENERATE("reverse", "random:0", "random:1", "random:7", "random:4294967295");
    const test::Variable schedule("PELAGE_SCHEDULE", order);
    for (const std::size_t group : {1u, 5u, 7u, 64u}) {
        CAPTURE(order, group);
        Roll all = roll(group * 13, 3, group);

        std::ranges::sort(all.who);
        for (std::size_t i = 0; i < all.who.size(); ++i) REQUIRE(all.who[i] == static_cast<cl_int>(i) + 1);
    }
}

TEST_CASE("work-items that do not wait for those before them are seen where the last comes first") {
    const Session session(select_device(), {});
    if (session.info().type != "cpu") {
        WARN("SKIPPED: the device takes the work-items of a group side by side");
        return;
    }
    std::vector<cl_int> before;
    {
        const test::Variable schedule("PELAGE_SCHEDULE", "reverse");
        before = roll(8, 1, 8).before;
    }
    CHECK(before == std::vector<cl_int>{-1, 0, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("without a schedule a program is what it was, with one its lines keep their numbers") {
    const std::string source = "kernel void nothing() {}\n";
    {
        const test::Variable none("PELAGE_SCHEDULE", nullptr);
        CHECK(scheduled(source) == source);
    }
    const test::Variable schedule("PELAGE_SCHEDULE", "random:9");
    CHECK_THAT(scheduled(source), Catch::Contains("#define PELAGE_SEED 9u\n") && Catch::EndsWith("#line 1\n" + source));
}
