// Machines other than this one: without devices, with poor devices, with too many of them.
#include "every_call.hpp"

#include "core/error.hpp"
#include "opencl/backend.hpp"
#include "opencl/device/device.hpp"
#include "support/form.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace pelage;
using Catch::Contains;
using test::Ending;
using test::Faults;
using test::Machine;
using test::Stage;

namespace {

using Platforms = std::vector<Machine::Platform>;

Faults& machine_with(const Platforms& platforms) {
    Faults& layer = Faults::layer();
    layer.reset();
    layer.machine.platforms = platforms;
    return layer;
}

// The manifest of a run that must succeed.
nlohmann::json manifest_of(Stage& stage) {
    Faults::layer().heal();
    const Ending ending = stage.run();
    INFO(ending.error);
    REQUIRE(ending.finished);
    return nlohmann::json::parse(test::read_all(stage.results() / "manifest.json"));
}

std::string error_of(Stage& stage) {
    Faults::layer().heal();
    const Ending ending = stage.run();
    CHECK_FALSE(ending.finished);
    return ending.error;
}

void check_equal_to_reference(Stage& stage) {
    Faults& layer = Faults::layer();
    layer.reset();
    stage.play_on_reference();
    const Ending ending = stage.run();

    INFO(ending.error);
    CHECK(ending.finished);
    CHECK(layer.count("clEnqueueNDRangeKernel") > 10);
    CHECK(layer.refused() == 0);
    test::check_nothing_broken(stage, ending);
    layer.reset();
}

}  // namespace

TEST_CASE("without a platform or a device there is the reference, and a clear answer to who wants a device") {
    const auto platforms = GENERATE(Platforms{}, Platforms{Machine::Platform::empty});
    machine_with(platforms);
    Stage stage(Stage::Play::lattice);
    stage.machine.platforms = platforms;

    CHECK(list_devices().empty());
    CHECK_THROWS_WITH(select_device(), Contains("no OpenCL device is there; install a driver"));
    CHECK_THROWS_WITH(select_device("gpu"), Contains("'gpu'") && Contains("no OpenCL device is there"));
    CHECK_THROWS_WITH(select_device("0"), Contains("no OpenCL device 0"));
    CHECK_THAT(error_of(stage), Contains("no OpenCL device is there"));
    stage.options().backend = "";
    CHECK(manifest_of(stage).at("backend") == "reference");
}

TEST_CASE("a platform without devices does not hide another one") {
    machine_with({Machine::Platform::real});
    const DeviceInfo alone = select_device();
    machine_with({Machine::Platform::empty, Machine::Platform::real});

    REQUIRE(list_devices().size() >= 1);
    CHECK(list_devices().front().name == alone.name);
    CHECK(select_device().index == alone.index);
}

TEST_CASE("a platform that fails is listed last with the reason, and moves no index") {
    machine_with({Machine::Platform::real});
    const std::size_t real = list_devices().size();
    machine_with({Machine::Platform::broken, Machine::Platform::real});
    const std::vector<DeviceInfo> devices = list_devices();

    REQUIRE(devices.size() == real + 1);
    CHECK(devices.back().platform == "Broken");
    CHECK(devices.back().index == real);
    CHECK_THAT(devices.back().unusable, Contains("clGetDeviceIDs failed with CL_OUT_OF_HOST_MEMORY"));
    CHECK(select_device().platform != "Broken");
    CHECK_THROWS_WITH(select_device(std::to_string(real)), Contains("CL_OUT_OF_HOST_MEMORY"));
    machine_with({Machine::Platform::broken});
    CHECK_THROWS_WITH(select_device(),
                      Contains("no usable OpenCL device") && Contains("Broken") && Contains("CL_OUT_OF_HOST_MEMORY"));
}

TEST_CASE("of two platforms with the same device the first one is taken, or the one an index names") {
    machine_with({Machine::Platform::real});
    const std::vector<DeviceInfo> once = list_devices();
    machine_with({Machine::Platform::real, Machine::Platform::real});
    const std::vector<DeviceInfo> twice = list_devices();
    const DeviceInfo usual = select_device();
    const std::size_t other = usual.index + once.size();

    REQUIRE(twice.size() == 2 * once.size());
    CHECK(usual.index < once.size());
    CHECK(twice[other].name == usual.name);
    CHECK(twice[other].platform == usual.platform);
    CHECK(select_device(usual.name).index == usual.index);
    CHECK(select_device(usual.type).index == usual.index);
    CHECK(select_device(std::to_string(other)).index == other);
    CHECK_THROWS_WITH(select_device("Quantum"),
                      Contains("0: " + twice[0].name) && Contains(std::to_string(other) + ": " + twice[other].name));
    OpenclOptions options;
    options.device = std::to_string(other);
    CHECK(opencl_backend(options)->device().index == other);
}

TEST_CASE("a device that is not available, or has no compiler, is not used") {
    const auto [question, reason] =
        GENERATE(std::pair(cl_device_info{CL_DEVICE_AVAILABLE}, std::string("the device is not available")),
                 std::pair(cl_device_info{CL_DEVICE_COMPILER_AVAILABLE}, std::string("the device has no compiler")));
    Faults::layer().reset();
    Stage stage(Stage::Play::lattice);
    stage.machine.answer(question, cl_bool{CL_FALSE});

    CHECK_THAT(error_of(stage), Contains("no usable OpenCL device") && Contains("cannot be used: " + reason));
    stage.options().device = "0";
    CHECK_THAT(error_of(stage), Contains("OpenCL device 0") && Contains("cannot be used: " + reason));
    stage.options().device = stage.options().backend = "";
    CHECK(manifest_of(stage).at("backend") == "reference");
}

TEST_CASE("a device that cannot tell what it is called is listed, and not used") {
    machine_with({Machine::Platform::real});
    Faults::layer().machine.answers[CL_DEVICE_NAME] = "";
    const std::vector<DeviceInfo> devices = list_devices();

    REQUIRE_FALSE(devices.empty());
    CHECK(devices.front().name == "unknown");
    CHECK_THAT(devices.front().unusable, Contains("clGetDeviceInfo failed with CL_INVALID_VALUE"));
    CHECK_THROWS_AS(select_device(), Error);
}

TEST_CASE("a device without double runs in float, and says so when double is wanted") {
    const bool knows_the_question = GENERATE(true, false);
    Stage stage(Stage::Play::lattice);
    stage.machine.without_double();
    if (!knows_the_question) stage.machine.answers[CL_DEVICE_DOUBLE_FP_CONFIG] = "";
    stage.options().no_cache = true;

    check_equal_to_reference(stage);
    stage.options().precision = Precision::double_;
    CHECK_THAT(error_of(stage), Contains("has no double precision"));
    stage.options().backend = "";
    CHECK(manifest_of(stage).at("backend") == "reference");
    CHECK_FALSE(Faults::layer().count("clBuildProgram") > 0);
}

TEST_CASE("free cells too are stepped in float without a double") {
    Stage stage(GENERATE(
        from_range(test::long_form() ? std::vector{Stage::Play::cells, Stage::Play::sorting, Stage::Play::cells_on_gpu}
                                     : std::vector{Stage::Play::cells})));
    stage.machine.without_double();
    stage.options().no_cache = true;

    check_equal_to_reference(stage);
}

TEST_CASE("a work-group of one is enough for everything") {
    const auto play = GENERATE(from_range(test::all_plays));
    Stage stage(play);
    stage.machine.work_group_limit(1);

    check_equal_to_reference(stage);
}

TEST_CASE("a work-group's limit along its first dimension is kept") {
    Stage stage(
        GENERATE(from_range(test::long_form() ? std::vector{Stage::Play::lattice_on_gpu, Stage::Play::cells_on_gpu}
                                              : std::vector{Stage::Play::cells_on_gpu})));
    stage.machine.work_group_limit(4);
    stage.machine.answer(CL_DEVICE_MAX_WORK_GROUP_SIZE, std::size_t{1024});

    check_equal_to_reference(stage);
}

TEST_CASE("where a kernel takes fewer work-items than its device says, groups are made smaller") {
    using Few = std::pair<std::size_t, Stage::Play>;
    std::vector<Few> few{{1, Stage::Play::lattice_on_gpu}, {4, Stage::Play::sorting}};
    if (test::long_form()) {
        few.insert(few.end(), {{4, Stage::Play::lattice_on_gpu},
                               {1, Stage::Play::cells_on_gpu},
                               {4, Stage::Play::cells_on_gpu},
                               {1, Stage::Play::sorting}});
    }
    const auto [items, play] = GENERATE_COPY(from_range(few));
    Stage stage(play);
    stage.machine.work_group = items;

    check_equal_to_reference(stage);
}

TEST_CASE("small experiments run on a device that allows small buffers only") {
    Stage stage(GENERATE(Stage::Play::lattice, Stage::Play::cells, Stage::Play::sorting));
    stage.machine.largest_buffer_limit(100'000);

    check_equal_to_reference(stage);
}

TEST_CASE("an experiment too large for a device's largest buffer is refused with the size and the limit") {
    const auto play = GENERATE(Stage::Play::lattice, Stage::Play::cells, Stage::Play::sorting);
    Faults::layer().reset();
    Stage stage(play);
    stage.machine.largest_buffer_limit(500);

    const std::string error = error_of(stage);

    INFO(error);
    CHECK_THAT(error, Contains("device '") && (Contains("allows at most 500") || Contains("in one piece")));
    CHECK(Faults::layer().refused() == 0);
    CHECK(Faults::layer().unbalanced().empty());
    CHECK(test::names_in(stage.results()).empty());
}

TEST_CASE("a driver that takes no compiled programs compiles them anew") {
    Stage stage(Stage::Play::lattice);
    stage.machine.binaries = false;

    check_equal_to_reference(stage);
}

TEST_CASE("PELAGE_DEVICE chooses by index, type and name, and is not passed over when nothing fits") {
    Faults::layer().reset();
    Stage stage(Stage::Play::lattice);
    stage.options().backend = "";
    const DeviceInfo usual = select_device();
    const auto device_under = [&](const std::string& value) {
        const test::Variable variable("PELAGE_DEVICE", value.c_str());
        return manifest_of(stage).at("device");
    };

    CHECK(device_under(std::to_string(usual.index)) == usual.name);
    CHECK(device_under(usual.type) == usual.name);
    CHECK(device_under(usual.name) == usual.name);
    CHECK(device_under("") == usual.name);
    const test::Variable variable("PELAGE_DEVICE", "abacus");
    CHECK_THAT(error_of(stage), Contains("'abacus'"));
    stage.options().device = std::to_string(usual.index);
    CHECK(manifest_of(stage).at("device") == usual.name);
    stage.options().device = "";
    stage.options().backend = "reference";
    CHECK(manifest_of(stage).at("backend") == "reference");
}
