// See allowance.hpp.
#include "core/allowance.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace pelage {

namespace {

namespace fs = std::filesystem;

struct Mount {
    std::string inside;  // the group that is seen at `place`
    std::string place;
    bool second = false;  // version 2
    std::string options;  // of version 1: names its controllers
};

bool has_word(const std::string& list, const std::string& word) {
    std::istringstream words(list);
    for (std::string each; std::getline(words, each, ',');) {
        if (each == word) return true;
    }
    return false;
}

// A line is: id, parent, device, root, place, options, more of them, "-", type, source, options of the file system.
std::vector<Mount> group_mounts(const fs::path& root) {
    std::vector<Mount> mounts;
    std::ifstream file(root / "proc/self/mountinfo");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string skipped, type;
        Mount mount;
        words >> skipped >> skipped >> skipped >> mount.inside >> mount.place;
        while (words >> skipped && skipped != "-") {
        }
        if (!(words >> type >> skipped >> mount.options)) continue;
        mount.second = type == "cgroup2";
        if (mount.second || type == "cgroup") mounts.push_back(mount);
    }
    return mounts;
}

// The group of this process as /proc/self/cgroup tells it: lines "id:controllers:path", id 0 for version 2.
std::optional<std::string> group_path(const fs::path& root, const Mount& mount, const std::string& controller) {
    std::ifstream file(root / "proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        const auto first = line.find(':');
        const auto second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (mount.second ? controllers.empty() : has_word(controllers, controller)) return line.substr(second + 1);
    }
    return {};
}

// The folders of the process's group and of all groups above it that can be seen.
std::vector<fs::path> levels(const fs::path& root, const Mount& mount, const std::string& path) {
    std::string below = path;
    if (mount.inside != "/") below = path.rfind(mount.inside, 0) == 0 ? path.substr(mount.inside.size()) : "";
    const fs::path top = root / fs::path(mount.place).relative_path();
    std::vector<fs::path> folders{top};
    for (const fs::path& part : fs::path(below).relative_path()) folders.push_back(folders.back() / part);
    return folders;
}

using Limit = std::function<std::optional<double>(const fs::path& folder, bool second)>;

std::optional<double> least(const fs::path& root, const std::string& controller, const Limit& limit) {
    std::optional<double> found;
    for (const Mount& mount : group_mounts(root)) {
        if (!mount.second && !has_word(mount.options, controller)) continue;
        const auto path = group_path(root, mount, controller);
        if (!path) continue;
        for (const fs::path& folder : levels(root, mount, *path)) {
            const auto here = limit(folder, mount.second);
            if (here && *here > 0) found = std::min(*here, found.value_or(*here));
        }
    }
    return found;
}

// The file's first number; nothing where it begins with a word ("max").
std::optional<double> number_in(const fs::path& file) {
    double value = 0;
    if (std::ifstream(file) >> value) return value;
    return {};
}

std::optional<double> processors_of(const fs::path& folder, bool second) {
    double quota = 0, period = 0;
    if (second) {
        if (!(std::ifstream(folder / "cpu.max") >> quota >> period)) return {};
    } else {
        quota = number_in(folder / "cpu.cfs_quota_us").value_or(-1);
        period = number_in(folder / "cpu.cfs_period_us").value_or(0);
    }
    if (quota <= 0 || period <= 0) return {};
    return quota / period;
}

struct Taken {  // bytes of this process
    double space = 0;
    double resident = 0;
    double data = 0;
};

Taken taken_by_now() {
    Taken taken;
    double shared = 0, text = 0, libraries = 0;
    std::ifstream("/proc/self/statm") >> taken.space >> taken.resident >> shared >> text >> libraries >> taken.data;
    const auto page = static_cast<double>(sysconf(_SC_PAGESIZE));
    return {page * taken.space, page * taken.resident, page * taken.data};
}

std::vector<bool> allowed_processors() {
    constexpr std::size_t most = 1 << 16;
    for (std::size_t count = CPU_SETSIZE; count <= most; count *= 2) {
        std::vector<cpu_set_t> set(count / CPU_SETSIZE);
        const std::size_t bytes = set.size() * sizeof(cpu_set_t);
        if (sched_getaffinity(0, bytes, set.data()) != 0) continue;
        std::vector<bool> allowed(count);
        for (std::size_t i = 0; i < count; ++i) allowed[i] = CPU_ISSET_S(i, bytes, set.data());
        return allowed;
    }
    return {};
}

}  // namespace

std::optional<double> group_memory(const fs::path& root) {
    return least(root, "memory", [](const fs::path& folder, bool second) {
        return number_in(folder / (second ? "memory.max" : "memory.limit_in_bytes"));
    });
}

std::optional<double> group_processors(const fs::path& root) { return least(root, "cpu", processors_of); }

std::optional<ProcessLimit> process_limit() {
    const Taken taken = taken_by_now();
    std::optional<ProcessLimit> tightest;
    const auto look = [&](auto resource, double size, const char* option) {
        rlimit limit{};
        if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
        const ProcessLimit found{static_cast<double>(limit.rlim_cur), size, option};
        if (!tightest || found.left() < tightest->left()) tightest = found;
    };
    look(RLIMIT_AS, taken.space, "ulimit -v");
    look(RLIMIT_DATA, taken.data, "ulimit -d");
    return tightest;
}

double usable_memory() {
    double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (const auto limit = group_memory()) bytes = std::min(bytes, *limit);
    bytes -= taken_by_now().resident;
    if (const auto limit = process_limit()) bytes = std::min(bytes, limit->left());
    return std::max(bytes, 0.0);
}

std::size_t usable_processors() {
    static const std::size_t known = [] {
        const std::vector<bool> allowed = allowed_processors();
        auto count = static_cast<std::size_t>(std::count(allowed.begin(), allowed.end(), true));
        if (count == 0) count = static_cast<std::size_t>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
        if (const auto quota = group_processors()) {
            count = std::min(count, static_cast<std::size_t>(std::max(1.0, std::ceil(*quota))));
        }
        return count;
    }();
    return known;
}

bool may_run_on_first(std::size_t count) {
    const std::vector<bool> allowed = allowed_processors();
    return count <= allowed.size() && std::all_of(allowed.begin(), allowed.begin() + static_cast<std::ptrdiff_t>(count),
                                                  [](bool is) { return is; });
}

}  // namespace pelage
