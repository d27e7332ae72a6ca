// Each error code of the standard at each OpenCL function, and tissues that go on after a failure.
#include "codes.hpp"
#include "core/searching.hpp"
#include "faults.hpp"

#include "core/error.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/session.hpp"
#include "verify/compare.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <set>

using namespace pelage;
using test::Faults;

namespace {

const std::string lattice_text =
    "define chemical U\nuse chemical U conc 1 dev 0.5 diff 1\nuse polarity 30 dev 60\ncreate matrix 5 4 wrap\n"
    "rule every 2 always expand columns 1\nrule always polarize U conc\n";
const std::string cells_text =
    "define chemical U\nuse chemical U conc 1 dev 0.5 diff 0.01\ncreate hex_circle 3\n"
    "rule always divide direction 0 dev 90\n";
const std::string launches_text = "define chemical U\nuse chemical U conc 1 dev 0.5 diff 0.1\ncreate matrix 5 4 wrap\n";

OpenclOptions options_of(bool sorting) {
    OpenclOptions options;
    if (sorting) options.neighbours = NeighbourSearch::spatial_sorting;
    return options;
}

// Something that a library user does; it makes a few OpenCL calls of many kinds.
struct Act {
    std::string name;
    std::function<void()> work;
};

void open() { opencl_backend(); }

void build(bool cached) {
    OpenclOptions options;
    options.use_cache = cached;
    options.cache_twice = cached;
    const Session session(select_device(), options);
    with_device(session.info().name, [&] { cl::Kernel(session.build("kernel void nothing() {}"), "nothing"); });
}

// A tissue that takes a state, advances and is read, again and again.
class Course {
public:
    Course(const std::string& text, bool sorting)
        : backend_(opencl_backend(options_of(sorting))),
          tissue_(backend_->make_tissue(parse_experiment(text, "course", "."))),
          initial_(tissue_->read()) {
        run();
        good_ = tissue_->read();
        REQUIRE(verify::mistrusted(initial_, good_).empty());
    }

    void run(std::uint64_t iterations = 3) {
        tissue_->write(initial_);
        tissue_->advance(iterations);
        tissue_->non_finite();
        search_statistics(*tissue_);
        tissue_->read();
    }

    void check_whole() {
        run();
        CHECK(verify::differences(good_, tissue_->read()).empty());
    }

private:
    std::unique_ptr<OpenclBackend> backend_;
    std::unique_ptr<Tissue> tissue_;
    Snapshot initial_, good_;
};

std::map<std::string, std::size_t> counts_of(const Act& act) {
    Faults& layer = Faults::layer();
    act.work();  // fills the cache
    layer.heal();
    act.work();
    std::map<std::string, std::size_t> counts;
    for (const test::Call& call : layer.calls()) ++counts[call.name];
    layer.heal();
    return counts;
}

// The call is made to fail in the middle of the act: that must end well, or in an Error which says why.
void fail_once(const Act& act, const std::string& name, std::size_t count, cl_int code) {
    INFO(fmt::format("{}: {} fails with {}", act.name, name, cl_error_name(code)));
    Faults& layer = Faults::layer();
    layer.heal();
    layer.fail(name, count / 2, code);
    try {
        act.work();
    } catch (const Error& error) {
        INFO(error.what());
        CHECK(test::tells(error.what(), name, code));
    }
    CHECK(layer.struck() == 1);
    layer.heal();
}

// Functions of OpenCL that this program takes from the library itself.
std::string functions_past_the_layer() {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> listing(popen("nm --undefined-only --dynamic /proc/$PPID/exe", "r"),
                                                            pclose);
    REQUIRE(listing != nullptr);
    std::string found;
    std::array<char, 512> line{};
    std::size_t lines = 0;
    for (; std::fgets(line.data(), line.size(), listing.get()) != nullptr; ++lines) {
        const std::string text = line.data();
        const auto name = text.find(" cl");
        if (name != std::string::npos && text.size() > name + 3 && std::isupper(text[name + 3]) != 0) found += text;
    }
    REQUIRE(lines > 10);
    return found;
}

}  // namespace

TEST_CASE("no OpenCL call goes past the layer") { CHECK(functions_past_the_layer().empty()); }

TEST_CASE("every function may fail with every code of the standard, and tissues go on with a new state") {
    Faults& layer = Faults::layer();
    layer.reset();
    std::size_t functions = 0;
    {
        Course lattice(lattice_text, false);
        Course cells(cells_text, false);
        Course sorting(cells_text, true);
        layer.machine.answer(CL_DEVICE_TYPE, cl_device_type{CL_DEVICE_TYPE_GPU});  // a launch an iteration
        Course launches(launches_text, false);
        layer.machine = {};
        const std::vector<Act> acts{{"open", open},
                                    {"build from the cache", [] { build(true); }},
                                    {"build", [] { build(false); }},
                                    {"lattice", [&] { lattice.run(); }},
                                    {"cells", [&] { cells.run(); }},
                                    {"spatial sorting", [&] { sorting.run(); }},
                                    {"many launches", [&] { launches.run(80); }}};
        std::set<std::string> done;

        for (const Act& act : acts) {
            const bool course = &act > &acts[2];
            for (const auto& [name, count] : counts_of(act)) {
                const bool first = done.insert(name).second;
                if (!first && !course) continue;
                for (const cl_int code : test::standard_codes()) {
                    if (first || code == CL_OUT_OF_RESOURCES) fail_once(act, name, count, code);
                }
            }
        }
        functions = done.size();
        lattice.check_whole();
        cells.check_whole();
        sorting.check_whole();
        launches.check_whole();
    }

    CHECK(functions >= 27);
    for (const std::string& text : layer.unbalanced()) FAIL_CHECK(text);
    layer.reset();
}

TEST_CASE("a build log that cannot be had does not hide the failure of the build") {
    Faults& layer = Faults::layer();
    layer.reset();
    for (const cl_int code : test::standard_codes()) {
        layer.heal();
        layer.fail("clBuildProgram", 0, CL_BUILD_PROGRAM_FAILURE);
        layer.fail("clGetProgramBuildInfo", 0, code);

        CHECK_THROWS_WITH(build(false), Catch::Contains("could not build a program (CL_BUILD_PROGRAM_FAILURE)") &&
                                            Catch::Contains("(none: " + cl_error_name(code) + ")"));
        CHECK(layer.struck() == 2);
        CHECK(layer.unbalanced().empty());
    }
    layer.reset();
}

TEST_CASE("a tissue whose change failed half-way says that its state is lost until it gets a new one") {
    Faults& layer = Faults::layer();
    layer.reset();
    const auto text = GENERATE_REF(lattice_text, cells_text);
    const auto backend = opencl_backend();
    const auto tissue = backend->make_tissue(parse_experiment(text, "course", "."));
    const Snapshot initial = tissue->read();
    tissue->advance(3);
    const Snapshot expected = tissue->read();
    tissue->write(initial);
    layer.heal();
    layer.fail("clEnqueueNDRangeKernel", 4, CL_OUT_OF_RESOURCES);

    REQUIRE_THROWS_WITH(tissue->advance(3), Catch::Contains("CL_OUT_OF_RESOURCES"));
    CHECK_THROWS_WITH(tissue->read(), Catch::Contains("state is lost"));
    CHECK_THROWS_WITH(tissue->advance(1), Catch::Contains("state is lost"));
    CHECK_THROWS_WITH(tissue->non_finite(), Catch::Contains("state is lost"));
    tissue->write(initial);
    tissue->advance(3);
    CHECK(verify::differences(expected, tissue->read()).empty());
    layer.heal();
}

TEST_CASE("a tissue whose reading failed can be read again") {
    Faults& layer = Faults::layer();
    layer.reset();
    const auto text = GENERATE_REF(lattice_text, cells_text);
    const auto backend = opencl_backend();
    const auto tissue = backend->make_tissue(parse_experiment(text, "course", "."));
    tissue->advance(3);
    const Snapshot expected = tissue->read();
    layer.heal();
    layer.fail("clEnqueueReadBuffer", 0, CL_OUT_OF_RESOURCES);

    CHECK_THROWS_WITH(tissue->read(), Catch::Contains("CL_OUT_OF_RESOURCES"));
    CHECK(verify::differences(expected, tissue->read()).empty());
    layer.heal();
}
