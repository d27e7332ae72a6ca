// Which device is taken, and what is said when there is none.
#include "opencl/device/device.hpp"

#include "core/error.hpp"
#include "opencl/backend.hpp"
#include "support/variable.hpp"

#include <catch2/catch.hpp>

using namespace pelage;
using Catch::Matchers::Contains;
using test::Variable;

namespace {

DeviceInfo device(std::size_t index, const std::string& name, const std::string& type,
                  const std::string& unusable = "") {
    DeviceInfo info;
    info.index = index;
    info.name = name;
    info.type = type;
    info.platform = "Some Platform";
    info.unusable = unusable;
    return info;
}

std::string failure(const std::vector<DeviceInfo>& devices, const std::optional<std::string>& wanted) {
    try {
        choose_device(devices, wanted);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

const std::vector<DeviceInfo> many{device(0, "llvmpipe (LLVM 15)", "gpu"),
                                   device(1, "pthread-cpu", "cpu"),
                                   device(2, "Broken Card", "gpu", "the device is not available"),
                                   device(3, "Radiant 9000", "gpu"),
                                   device(4, "Radiant 9001", "gpu"),
                                   device(5, "Abacus", "accelerator")};

}  // namespace

TEST_CASE("the first real GPU is the default, then a CPU, then what there is") {
    REQUIRE(choose_device(many, {}) == 3);
    REQUIRE(choose_device({many[0], many[1], many[5]}, {}) == 1);
    REQUIRE(choose_device({many[0], many[5]}, {}) == 1);
    REQUIRE(choose_device({many[2], many[0]}, {}) == 1);
}

TEST_CASE("a device is named by index, type or part of its name in any case") {
    REQUIRE(choose_device(many, "4") == 4);
    REQUIRE(choose_device(many, "cpu") == 1);
    REQUIRE(choose_device(many, "GPU") == 3);
    REQUIRE(choose_device(many, "accelerator") == 5);
    REQUIRE(choose_device(many, "radiant") == 3);
    REQUIRE(choose_device(many, "ant 9001") == 4);
    REQUIRE(choose_device(many, "LLVMpipe") == 0);
}

TEST_CASE("a platform's name chooses its best device, where no device has that name") {
    std::vector<DeviceInfo> devices = many;
    devices[1].platform = "Portable Computing Language";
    devices[1].platform_version = "OpenCL 3.0 PoCL 3.1";
    devices[5].platform = "Radiant Compute";

    REQUIRE(choose_device(devices, "portable computing") == 1);
    REQUIRE(choose_device(devices, "pocl") == 1);
    REQUIRE(choose_device(devices, "radiant") == 3);
    REQUIRE(choose_device(devices, "some platform") == 3);
    REQUIRE_THAT(failure(devices, "quantum"), Contains("no usable OpenCL device or platform"));
}

TEST_CASE("a device that is not there is answered with those that are") {
    REQUIRE_THAT(failure(many, "6"),
                 Contains("no OpenCL device 6") && Contains("3: Radiant 9000 (gpu, Some Platform)"));
    REQUIRE_THAT(failure(many, "Quantum"),
                 Contains("'quantum'") && Contains("1: pthread-cpu") && Contains("5: Abacus"));
    REQUIRE_THAT(failure(many, "2"), Contains("Broken Card") && Contains("the device is not available"));
    REQUIRE_THAT(failure(many, "broken"), Contains("cannot be used: the device is not available"));
    REQUIRE_THAT(failure({}, {}), Contains("no OpenCL device is there"));
    REQUIRE_THAT(failure({}, "gpu"), Contains("no OpenCL device is there"));
    REQUIRE_THAT(failure({many[2]}, {}), Contains("no usable OpenCL device"));
}

TEST_CASE("the environment names a device when nobody else does") {
    const std::vector<DeviceInfo> here = list_devices();
    REQUIRE_FALSE(here.empty());
    const DeviceInfo usual = select_device();
    const Variable variable("PELAGE_DEVICE", "no such device");

    REQUIRE_THROWS_WITH(select_device(), Contains("PELAGE_DEVICE asks for 'no such device'"));
    REQUIRE(select_device(std::to_string(usual.index)).name == usual.name);
    REQUIRE_THROWS_AS(opencl_backend(), Error);
}

TEST_CASE("devices here are described") {
    for (const DeviceInfo& info : list_devices()) {
        INFO(info.name);
        REQUIRE_FALSE(info.name.empty());
        REQUIRE_FALSE(info.platform.empty());
        if (!info.unusable.empty()) continue;
        REQUIRE(info.memory > 0);
        REQUIRE(info.max_allocation > 0);
        REQUIRE(info.compute_units > 0);
        REQUIRE(info.max_work_group > 0);
    }
}
