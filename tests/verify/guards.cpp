// Guarded sessions: a stray write is caught at the launch that made it, and what was not written is NaN.
#include "core/error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/session.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

Session guarded() {
    OpenclOptions options;
    options.guarded = true;
    return Session(select_device(), options);
}

const char* const put = R"(
kernel void put(global float* to, const int place) { to[place] = 1.0f; }
kernel void look(global const float* from, const int place, global float* to) { to[0] = from[place]; }
)";

std::string complaint(const Session& on, const cl::Buffer& buffer, int place) {
    cl::Kernel kernel(on.build(put), "put");
    Arguments(on, kernel).add(buffer, static_cast<cl_int>(place));
    try {
        launch(on, kernel, 1);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a write one element past either end of a buffer is caught, with kernel and buffer") {
    const Session on = guarded();
    const cl::Buffer first = on.buffer(100 * 4, "concentrations");
    const cl::Buffer second = on.buffer(64 * 4, "rates");

    REQUIRE(complaint(on, first, 0).empty());
    REQUIRE(complaint(on, first, 99).empty());
    REQUIRE_THAT(complaint(on, first, 100), Contains("'put'") && Contains("concentrations") &&
                                                Contains("0 bytes after its end") && Contains("400 bytes"));
    REQUIRE_THAT(complaint(on, second, -1), Contains("concentrations") || Contains("rates"));
}

TEST_CASE("a write before the beginning is caught") {
    const Session on = guarded();
    const cl::Buffer buffer = on.buffer(64 * 4, "rates");

    REQUIRE_THAT(complaint(on, buffer, -2), Contains("rates") && Contains("8 bytes before its beginning"));
}

TEST_CASE("buffers that were given back are no longer looked at") {
    const Session on = guarded();
    const cl::Buffer kept = on.buffer(64 * 4, "rates");
    for (int i = 0; i < 100; ++i) {
        const cl::Buffer gone = on.buffer(1'000'000, "something large");
        REQUIRE(complaint(on, gone, 5).empty());
    }

    REQUIRE(complaint(on, kept, 63).empty());
}

TEST_CASE("what nobody wrote is NaN, beyond the ends too") {
    const Session on = guarded();
    const cl::Buffer buffer = on.buffer(10 * 4, "fresh values");
    const cl::Buffer result = on.buffer(4, "result");
    cl::Kernel look(on.build(put), "look");
    for (const cl_int place : {0, 9, 10, -1}) {
        Arguments(on, look).add(buffer, place, result);
        launch(on, look, 1);
        float found = 0;
        on.queue().enqueueReadBuffer(result, CL_TRUE, 0, 4, &found);
        REQUIRE(std::isnan(found));
    }
}

TEST_CASE("poison is no number in float and double, and can be put back") {
    const Session on = guarded();
    const cl::Buffer buffer = on.buffer(16, "values");
    const double zeros[2] = {0, 0};
    on.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, 16, zeros);

    on.poison_buffer(buffer, 16);

    double found[2];
    on.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, 16, found);
    REQUIRE(std::isnan(found[0]));
    REQUIRE(std::isnan(found[1]));
}
