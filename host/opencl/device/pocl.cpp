// See pocl.hpp.
#include "opencl/device/pocl.hpp"

#include "core/allowance.hpp"
#include "core/error.hpp"
#include "io/locked.hpp"
#include "opencl/device/cache.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace pelage {

namespace {

namespace fs = std::filesystem;

constexpr const char* folder_beginning = "pelage-pocl-";
constexpr std::size_t most_threads = 64;     // or as many as there are processors
constexpr double least_room = 32 << 20;      // bytes on the disk
constexpr double largest_program = 4 << 20;  // bytes in a file that PoCL writes

struct Preparation {
    std::unique_ptr<PrivateFolder> folder;
    std::string trouble;
};

std::optional<std::string> variable(const char* name) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') return {};
    return value;
}

// Why PoCL cannot keep and load programs in `folder`; empty: it can.
std::string why_not_in(const fs::path& folder) {
    struct statvfs status {};
    if (statvfs(folder.c_str(), &status) != 0) return fmt::format("'{}' is not there", folder.string());
    if ((status.f_flag & ST_NOEXEC) != 0) return fmt::format("'{}' allows no programs", folder.string());
    const double room = static_cast<double>(status.f_bavail) * static_cast<double>(status.f_frsize);
    if (status.f_blocks != 0 && room < least_room) return fmt::format("'{}' is full", folder.string());
    return {};
}

std::unique_ptr<PrivateFolder> folder_in(const fs::path& parent, std::string& trouble) {
    std::string reason = why_not_in(parent);
    if (reason.empty()) {
        try {
            remove_left_over(parent, folder_beginning, "");
            return std::make_unique<PrivateFolder>(parent, folder_beginning);
        } catch (const Error& error) {
            reason = error.what();
        }
    }
    trouble += (trouble.empty() ? "" : "; ") + reason;
    return nullptr;
}

// Where a private folder may lie, the best place first.
std::vector<fs::path> parents() {
    std::vector<fs::path> places;
    std::error_code failure;
    if (const auto set = variable("POCL_CACHE_DIR")) {
        fs::create_directories(*set, failure);
        places.emplace_back(*set);
    }
    const fs::path temporary = fs::temp_directory_path(failure);
    if (!failure) places.push_back(temporary);
    for (const char* place : {"/tmp", "/var/tmp", "/dev/shm"}) {
        if (temporary != place) places.emplace_back(place);
    }
    if (const fs::path own = cache_folder(); !own.empty()) places.push_back(own);
    return places;
}

void find_folder(Preparation& preparation) {
    std::string trouble;
    for (const fs::path& parent : parents()) {
        std::error_code failure;
        if (parent == cache_folder()) fs::create_directories(parent, failure);  // only where no other place will do
        preparation.folder = folder_in(parent, trouble);
        if (!preparation.folder) continue;
        setenv("POCL_CACHE_DIR", preparation.folder->path().c_str(), 1);
        return;
    }
    preparation.trouble = "PoCL finds no folder to compile in: " + trouble;
}

void check_file_size(Preparation& preparation) {
    rlimit limit{};
    if (getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
    if (static_cast<double>(limit.rlim_cur) >= largest_program) return;
    preparation.trouble =
        fmt::format("PoCL keeps programs in files, and files may have {} bytes at most (ulimit -f)", limit.rlim_cur);
}

void set_threads() {
    const auto there = static_cast<std::size_t>(std::max(1L, sysconf(_SC_NPROCESSORS_CONF)));
    const std::size_t usable = usable_processors();
    const auto set = variable("POCL_MAX_PTHREAD_COUNT");
    const long asked = set ? std::atol(set->c_str()) : 0;
    const std::size_t threads =
        asked > 0 ? std::min(static_cast<std::size_t>(asked), std::max(most_threads, usable)) : usable;
    if (set || usable < there) setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(threads).c_str(), 1);
    const std::string ranks_here = variable("OMPI_COMM_WORLD_LOCAL_SIZE").value_or("1");
    const bool ours = usable == there && threads == there && ranks_here == "1";
    const bool bound = variable("POCL_AFFINITY") ? *variable("POCL_AFFINITY") != "0" : ours;
    setenv("POCL_AFFINITY", bound && may_run_on_first(threads) ? "1" : "0", 1);
}

bool affinity_was_set = false;

std::atomic<const char*> folder_name{nullptr};

Preparation& preparation() {
    static Preparation known;
    return known;
}

}  // namespace

void prepare_pocl() {
    static std::once_flag once;
    std::call_once(once, [] {
        affinity_was_set = variable("POCL_AFFINITY").has_value();
        set_threads();
        find_folder(preparation());
        check_file_size(preparation());
        if (preparation().folder) folder_name = preparation().folder->path().c_str();
    });
}

void share_processors() {
    prepare_pocl();
    if (!affinity_was_set) setenv("POCL_AFFINITY", "0", 1);
}

fs::path pocl_folder() {
    const auto& folder = preparation().folder;
    return folder ? folder->path() : fs::path();
}

const char* pocl_folder_name() { return folder_name; }

std::string pocl_trouble() { return preparation().trouble; }

}  // namespace pelage
