// Programs on the device: random numbers by the book, and what a failed build or call says.
#include "core/philox.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/program.hpp"
#include "opencl/device/session.hpp"
#include "support/variable.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

Session session() {
    OpenclOptions options;
    options.use_cache = false;
    return Session(select_device(), options);
}

const char* const philox_kernel = R"(
kernel void philox(global const uint* in, global uint* out) {
    const size_t i = get_global_id(0);
    global const uint* c = in + 6 * i;
    const struct pelage_words w = pelage_philox4x32_10((uintv)(c[0]), (uintv)(c[1]), (uintv)(c[2]), (uintv)(c[3]), c[4], c[5]);
    out[4 * i] = FIRST(w.x); out[4 * i + 1] = FIRST(w.y); out[4 * i + 2] = FIRST(w.z); out[4 * i + 3] = FIRST(w.w);
}
)";

using Words = std::vector<cl_uint>;

Words philox(const Session& on, const Words& inputs, const std::string& settings) {
    Source source;
    source.text(settings).file("common/prelude.cl").file("rules/philox.cl").text(philox_kernel);
    cl::Kernel kernel(on.build(source.str()), "philox");
    const std::size_t count = inputs.size() / 6;
    const cl::Buffer in = on.buffer(inputs.size() * 4, "counters");
    const cl::Buffer out = on.buffer(count * 16, "draws");
    on.queue().enqueueWriteBuffer(in, CL_TRUE, 0, inputs.size() * 4, inputs.data());
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    on.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count));
    Words words(count * 4);
    on.queue().enqueueReadBuffer(out, CL_TRUE, 0, words.size() * 4, words.data());
    return words;
}

std::string build_failure(const Session& on, const std::string& source) {
    try {
        on.build(source);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("Philox4x32-10 gives the published answers on the device") {
    const Session on = session();
    const Words inputs{0,          0,          0,          0,          0,          0,
                       0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff,
                       0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344, 0xa4093822, 0x299f31d0};
    const Words answers{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8, 0x408f276d, 0x41c83b0e,
                        0xa20bc7c6, 0x6d5451fd, 0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1};

    REQUIRE(philox(on, inputs, "#define FIRST(v) (v)") == answers);
    REQUIRE(philox(on, inputs, "#define PELAGE_WIDTH 4\n#define FIRST(v) (v).s3") == answers);
}

TEST_CASE("device and host draw the same numbers") {
    const Session on = session();
    Words inputs;
    Words expected;
    for (std::uint32_t i = 0; i < 5000; ++i) {
        const std::array<std::uint32_t, 4> counter{i, i * i, i % 7, i % 64};
        const std::array<std::uint32_t, 2> key{i * 2654435761u, 12345 - i};
        inputs.insert(inputs.end(), {counter[0], counter[1], counter[2], counter[3], key[0], key[1]});
        for (const std::uint32_t word : philox4x32_10(counter, key)) expected.push_back(word);
    }

    REQUIRE(philox(on, inputs, "#define FIRST(v) (v)") == expected);
}

TEST_CASE("on PoCL a program needs clang's header only for what ours do not call") {
    const Session on = session();
    if (on.info().platform != "Portable Computing Language") {
        std::cout << "SKIPPED: the device is not PoCL's\n";
        return;
    }
    const std::string foreign = "kernel void f(global float* a) { a[0] = tanh(a[1]); }\n";
    const std::string wrong = "kernel void f(global float* a) {\n    a[0] = not_a_function(a[1]);\n}\n";
    {
        const test::Variable never("PELAGE_POCL_HEADER", "never");
        REQUIRE_THAT(build_failure(on, foreign), Contains("tanh"));
        REQUIRE_THAT(build_failure(on, wrong), Contains("2:"));  // the line that it has in its own source
        REQUIRE(build_failure(on, "kernel void f(global float* a) { a[0] = fma(a[1], a[2], a[3]); }\n").empty());
    }
    for (const char* header : {static_cast<const char*>(nullptr), "always"}) {
        const test::Variable own("PELAGE_POCL_HEADER", header);
        REQUIRE(build_failure(session(), foreign).empty());
        REQUIRE_THAT(build_failure(session(), wrong), Contains("not_a_function"));
    }
}

TEST_CASE("a failed build names device, options, log and the source") {
    const Session on = session();
    const std::string source = "kernel void broken(global float* a) { a[0] = not_a_function(1); }\n";

    const std::string text = build_failure(on, source);

    REQUIRE_THAT(text, Contains(on.info().name) && Contains("-cl-std=CL1.2") && Contains("CL_BUILD_PROGRAM_FAILURE"));
    REQUIRE_THAT(text, Contains("not_a_function") && Contains(on.info().driver));
    const auto start = text.find("source:  ") + 9;
    const std::filesystem::path path = text.substr(start, text.find('\n', start) - start);
    std::ifstream file(path);
    const std::string kept{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    REQUIRE(kept == source);
    std::filesystem::remove(path);
}

TEST_CASE("a failed call names itself, its error and the device") {
    const Session on = session();

    const Error error = cl_failure(cl::Error(CL_OUT_OF_RESOURCES, "clEnqueueNDRangeKernel"), on.info().name);

    REQUIRE_THAT(error.what(), Contains("clEnqueueNDRangeKernel") && Contains("CL_OUT_OF_RESOURCES (-5)"));
    REQUIRE_THAT(error.what(), Contains(on.info().name));
    REQUIRE(cl_error_name(-9999) == "error -9999");
    REQUIRE_THROWS_AS(with_device("it", [] { throw cl::Error(-30, "clFinish"); }), Error);
}

TEST_CASE("a buffer too large for the device is refused with its purpose and size") {
    const Session on = session();
    const std::size_t bytes = on.info().max_allocation + 1;

    try {
        on.buffer(bytes, "concentrations");
        FAIL("no error");
    } catch (const Error& error) {
        REQUIRE_THAT(error.what(), Contains("concentrations") && Contains(std::to_string(bytes)));
    }
}

TEST_CASE("kernel files are found, and every place in them must be filled") {
    Source source;

    REQUIRE_THROWS_AS(kernel_text("no_such.cl"), Error);
    REQUIRE_THROWS_AS(source.file("lattice/step.cl", {}), Error);
    REQUIRE_THROWS_AS(source.file("common/prelude.cl", {{"rules", "x"}}), Error);
}

// The number makes it a program that no cache has. A process that ended while PoCL compiles it would be aborted.
TEST_CASE("all sessions of a device share its context, and the last one takes it along") {
    OpenclOptions in_double;
    in_double.precision = Precision::double_;
    cl_context known = nullptr;
    cl_uint users = 0;
    {
        const Session first = session();
        known = first.context()();
        const Session second(select_device(), in_double);
        CHECK(second.context()() == known);
        CHECK(clGetContextInfo(known, CL_CONTEXT_REFERENCE_COUNT, sizeof users, &users, nullptr) == CL_SUCCESS);
        CHECK(clRetainContext(known) == CL_SUCCESS);
    }
    cl_uint left = 0;
    CHECK(clGetContextInfo(known, CL_CONTEXT_REFERENCE_COUNT, sizeof left, &left, nullptr) == CL_SUCCESS);
    CHECK(left == 1);
    CHECK(users > left);
    CHECK(clReleaseContext(known) == CL_SUCCESS);
}

TEST_CASE("a session that goes waits for what it has launched") {
    cl::Event launched;
    {
        const Session on = session();
        const auto number = std::chrono::steady_clock::now().time_since_epoch().count();
        cl::Kernel kernel(on.build("kernel void f(global long* a) { a[0] = " + std::to_string(number) + "; }"), "f");
        const cl::Buffer buffer = on.buffer(8, "number");
        kernel.setArg(0, buffer);
        on.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1), cl::NullRange, nullptr, &launched);
        on.queue().flush();
    }
    CHECK(launched.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() == CL_COMPLETE);
}
