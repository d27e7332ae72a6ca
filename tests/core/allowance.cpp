// What control groups leave to a process, read from folders made up for it.
#include "core/allowance.hpp"

#include <unistd.h>
#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace fs = std::filesystem;
using pelage::group_memory;
using pelage::group_processors;

namespace {

class Root {  // of a machine
public:
    Root() {
        std::string pattern = (fs::temp_directory_path() / "pelage-allowance-XXXXXX").string();
        REQUIRE(mkdtemp(pattern.data()) != nullptr);
        path = pattern;
    }
    ~Root() { fs::remove_all(path); }
    Root(const Root&) = delete;
    Root& operator=(const Root&) = delete;

    void put(const std::string& file, const std::string& text) const {
        fs::create_directories((path / file).parent_path());
        std::ofstream(path / file) << text;
    }

    fs::path path;
};

void second_version(const Root& root, const std::string& group, const std::string& inside = "/") {
    root.put("proc/self/mountinfo", "22 1 8:1 / / rw - ext4 /dev/sda1 rw\n30 22 0:26 " + inside +
                                        " /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw,nsdelegate\n");
    root.put("proc/self/cgroup", "0::" + group + "\n");
}

void first_version(const Root& root, const std::string& group, const std::string& inside) {
    root.put("proc/self/mountinfo", "31 22 0:27 " + inside +
                                        " /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory\n32 22 0:28 " + inside +
                                        " /sys/fs/cgroup/cpu,cpuacct rw - cgroup cgroup rw,cpu,cpuacct\n");
    root.put("proc/self/cgroup", "5:memory:" + group + "\n4:cpu,cpuacct:" + group + "\n1:name=systemd:/\n");
}

}  // namespace

TEST_CASE("without control groups nothing is limited") {
    const Root root;

    CHECK_FALSE(group_memory(root.path));
    CHECK_FALSE(group_processors(root.path));
    CHECK(pelage::usable_memory() > 0);
    CHECK(pelage::usable_processors() >= 1);
}

TEST_CASE("the least limit of all levels of version 2 holds") {
    const Root root;
    second_version(root, "/user.slice/job.scope");
    root.put("sys/fs/cgroup/user.slice/memory.max", "1000\n");
    root.put("sys/fs/cgroup/user.slice/cpu.max", "max 100000\n");
    root.put("sys/fs/cgroup/user.slice/job.scope/memory.max", "max\n");
    root.put("sys/fs/cgroup/user.slice/job.scope/cpu.max", "150000 100000\n");

    CHECK(group_memory(root.path) == 1000.0);
    CHECK(group_processors(root.path) == 1.5);

    root.put("sys/fs/cgroup/user.slice/job.scope/memory.max", "700\n");
    root.put("sys/fs/cgroup/user.slice/cpu.max", "50000 100000\n");
    CHECK(group_memory(root.path) == 700.0);
    CHECK(group_processors(root.path) == 0.5);
}

TEST_CASE("a group of version 2 that a container sees as the topmost one is read there") {
    const Root root;
    second_version(root, "/");
    root.put("sys/fs/cgroup/memory.max", "5000\n");

    CHECK(group_memory(root.path) == 5000.0);
    CHECK_FALSE(group_processors(root.path));
}

TEST_CASE("the limits of version 1 are found, in a container too") {
    const Root root;
    const std::string inside = GENERATE(as<std::string>(), "/", "/docker/1");
    first_version(root, "/docker/1", inside);
    const std::string below = inside == "/" ? "/docker/1" : "";
    root.put("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
    root.put("sys/fs/cgroup/memory" + below + "/memory.limit_in_bytes", "3000\n");
    root.put("sys/fs/cgroup/cpu,cpuacct" + below + "/cpu.cfs_quota_us", "200000\n");
    root.put("sys/fs/cgroup/cpu,cpuacct" + below + "/cpu.cfs_period_us", "100000\n");

    CHECK(group_memory(root.path) == 3000.0);
    CHECK(group_processors(root.path) == 2.0);

    root.put("sys/fs/cgroup/cpu,cpuacct" + below + "/cpu.cfs_quota_us", "-1\n");
    CHECK_FALSE(group_processors(root.path));
}
