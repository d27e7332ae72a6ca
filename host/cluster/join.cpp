// See ranks.hpp. What speaks MPI is a module beside the command, opened only where ranks were started: a command that
// runs alone neither needs MPI nor waits for its start.
#include "cluster/mpi_module.hpp"
#include "core/error.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

namespace pelage::cluster {

namespace {

// The variables by which Open MPI, MPICH and Slurm's PMI tell a process how many it is one of.
bool started_together() {
    const std::array<const char*, 2> names{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
    return std::ranges::any_of(names, [](const char* name) {
        const char* count = std::getenv(name);
        return count != nullptr && std::atoi(count) > 1;
    });
}

std::filesystem::path module_path() {
    std::error_code failure;
    return std::filesystem::read_symlink("/proc/self/exe", failure).parent_path() / mpi_module_file;
}

[[noreturn]] void refuse(const std::string& why) {
    throw Error(
        fmt::format("several processes were started together, but {}; build Pelage where libopenmpi-dev is "
                    "installed, or start one process",
                    why));
}

}  // namespace

std::unique_ptr<Ranks> join_ranks() {
    if (!started_together()) return nullptr;
    const std::filesystem::path path = module_path();
    std::error_code failure;
    if (!std::filesystem::exists(path, failure)) refuse(fmt::format("'{}' is not there", path.string()));
    void* const module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);  // MPI opens parts of its own that look in it
    if (module == nullptr) refuse(fmt::format("'{}' cannot be opened ({})", path.string(), ::dlerror()));
    const auto make = reinterpret_cast<MakeRanks>(::dlsym(module, mpi_module_entry));
    if (make == nullptr) refuse(fmt::format("'{}' is of another version", path.string()));
    return std::unique_ptr<Ranks>(make());
}

}  // namespace pelage::cluster
