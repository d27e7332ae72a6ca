// The cache of compiled programs: damage, staleness and competition cost time, never correctness.
#include "opencl/device/cache.hpp"

#include "lattice_run.hpp"
#include "opencl/device/pocl_programs.hpp"
#include "opencl/device/program.hpp"
#include "opencl/device/session.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace pelage;
namespace fs = std::filesystem;

namespace {

class Folder {  // a cache of its own for the time of a test
public:
    Folder() : path(fs::temp_directory_path() / ("pelage-cache-test-" + std::to_string(::getpid()))) {
        fs::remove_all(path);
        if (const char* before = std::getenv("PELAGE_CACHE")) before_ = before;
        setenv("PELAGE_CACHE", path.c_str(), 1);
    }
    ~Folder() {
        if (before_) setenv("PELAGE_CACHE", before_->c_str(), 1);
        if (!before_) unsetenv("PELAGE_CACHE");
        fs::remove_all(path);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        if (!fs::is_directory(path)) return found;
        for (const auto& entry : fs::directory_iterator(path)) found.push_back(entry.path());
        return found;
    }

    const fs::path path;

private:
    std::optional<std::string> before_;
};

const CacheKey key{"kernel void f() {}", "-O", "device", "OpenCL 3.0", "driver 1", "platform"};
const Binary binary{0, 1, 2, 255, '\n', 0, 7};

void overwrite(const fs::path& file, std::size_t place, char byte) {
    std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(static_cast<std::streamoff>(place));
    stream.put(byte);
}

const char* const triple = "kernel void f(global int* a) { a[get_global_id(0)] = 3 * (int)get_global_id(0); }";

OpenclOptions keeping() {
    OpenclOptions options;
    options.cache_twice = true;
    return options;
}

CacheKey key_of(const Session& session, const char* source) {
    return program_key(session, source, session.build_options());
}

// Builds and runs a program through the cache; true when it computed what it should.
bool works() {
    const Session session(select_device(), keeping());
    cl::Kernel kernel(session.build(triple), "f");
    const cl::Buffer buffer = session.buffer(64, "results");
    kernel.setArg(0, buffer);
    session.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(16));
    std::vector<cl_int> values(16);
    session.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, 64, values.data());
    return values[0] == 0 && values[5] == 15 && values[15] == 45;
}

}  // namespace

TEST_CASE("what a session has compiled is in the cache while the session goes on, once it is asked for") {
    const Folder folder;
    const Session session(select_device(), {});
    cl::Kernel kernel(session.build("kernel void f(global int* a) { a[get_global_id(0)] = 7; }"), "f");
    const cl::Buffer buffer = session.buffer(64, "results");
    kernel.setArg(0, buffer);
    session.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(16));
    session.queue().finish();

    keep_compiled();

    CHECK(folder.files().size() == 1);
}

TEST_CASE("what was stored is loaded") {
    const Folder folder;

    REQUIRE_FALSE(load_cached(folder.path, key).has_value());
    REQUIRE(store_cached(folder.path, key, binary));

    REQUIRE(load_cached(folder.path, key) == binary);
    REQUIRE(folder.files().size() == 1);
}

TEST_CASE("any other source, option, device, driver or platform is another entry") {
    const Folder folder;
    store_cached(folder.path, key, binary);
    std::vector<CacheKey> others(6, key);
    others[0].source += " ";
    others[1].options = "-O2";
    others[2].device = "devicf";
    others[3].device_version = "OpenCL 3.1";
    others[4].driver = "driver 2";
    others[5].platform = "";

    for (const CacheKey& other : others) REQUIRE_FALSE(load_cached(folder.path, other).has_value());
}

TEST_CASE("a stale entry under the right name is not taken") {
    const Folder folder;
    CacheKey older = key;
    older.driver = "driver 0";
    store_cached(folder.path, older, binary);
    fs::rename(cache_file(folder.path, older), cache_file(folder.path, key));

    REQUIRE_FALSE(load_cached(folder.path, key).has_value());
    REQUIRE(store_cached(folder.path, key, binary));
    REQUIRE(load_cached(folder.path, key) == binary);
}

TEST_CASE("no damaged byte and no lost end passes") {
    const Folder folder;
    store_cached(folder.path, key, binary);
    const fs::path file = cache_file(folder.path, key);
    const std::size_t size = fs::file_size(file);

    for (std::size_t place = 0; place < size; ++place) {
        store_cached(folder.path, key, binary);
        overwrite(file, place, '~');
        REQUIRE_FALSE(load_cached(folder.path, key).has_value());
    }
    for (std::size_t length = 0; length < size; ++length) {
        store_cached(folder.path, key, binary);
        fs::resize_file(file, length);
        REQUIRE_FALSE(load_cached(folder.path, key).has_value());
    }
}

TEST_CASE("a program is kept, and built from source again where its entry is damaged") {
    const Folder folder;
    REQUIRE(works());
    const CacheKey kept = key_of(Session(select_device(), keeping()), triple);
    const fs::path file = cache_file(folder.path, kept);
    REQUIRE(folder.files() == std::vector<fs::path>{file});
    REQUIRE(works());

    overwrite(file, fs::file_size(file) / 2, '\0');
    overwrite(file, fs::file_size(file) / 2 + 1, '~');
    REQUIRE_FALSE(load_cached(folder.path, kept).has_value());
    REQUIRE(works());
    REQUIRE(load_cached(folder.path, kept).has_value());
    fs::resize_file(file, fs::file_size(file) / 3);
    REQUIRE(works());

    REQUIRE(load_cached(folder.path, kept).has_value());
}

TEST_CASE("an entry that the driver refuses falls back to the source") {
    const Folder folder;
    const Session session(select_device(), keeping());
    const char* const source = "kernel void f(global int* a) { a[0] = 1; }";
    const CacheKey same = key_of(session, source);
    store_cached(folder.path, same, binary);  // sound as a file, nonsense as a program

    const cl::Program program = session.build(source);

    REQUIRE(program.getInfo<CL_PROGRAM_KERNEL_NAMES>() == "f");
    REQUIRE(load_cached(folder.path, same) != binary);
}

TEST_CASE("a cache that cannot be written, or is not wanted, is done without") {
    const Folder folder;
    std::ofstream(folder.path) << "a file where the folder should be";
    REQUIRE(works());
    REQUIRE_FALSE(store_cached(folder.path, key, binary));
    REQUIRE_FALSE(load_cached(folder.path, key).has_value());
    fs::remove(folder.path);

    OpenclOptions options;
    options.use_cache = false;
    const Session session(select_device(), options);
    session.build("kernel void g(global int* a) { a[0] = 1; }");

    REQUIRE(folder.files().empty());
}

TEST_CASE("the folder follows the environment") {
    const Folder folder;
    REQUIRE(cache_folder() == folder.path);
}

TEST_CASE("processes that store at once leave one sound entry") {
    const Folder folder;
    const Binary large(300'000, 42);
    std::vector<pid_t> children;
    for (int i = 0; i < 4; ++i) {
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            bool sound = true;
            for (int round = 0; round < 40; ++round) {
                sound = store_cached(folder.path, key, large) && load_cached(folder.path, key) == large && sound;
            }
            ::_exit(sound ? 0 : 1);
        }
        children.push_back(child);
    }

    for (const pid_t child : children) {
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        REQUIRE((WIFEXITED(status) && WEXITSTATUS(status) == 0));
    }
    REQUIRE(load_cached(folder.path, key) == large);
    REQUIRE(folder.files().size() == 1);
}
