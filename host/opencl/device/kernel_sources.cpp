// See kernel_sources.hpp.
#include "opencl/device/kernel_sources.hpp"

#include "core/error.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace pelage {

std::map<std::string, std::string> read_kernels(const std::filesystem::path& folder) {
    std::map<std::string, std::string> texts;
    for (const auto& [name, embedded] : embedded_kernels()) {
        std::ifstream file(folder / name, std::ios::binary);
        std::string text{std::istreambuf_iterator<char>(file), {}};
        if (!file || text.empty())
            throw Error("PELAGE_KERNELS: '" + (folder / name).string() + "' cannot be read, or is empty");
        texts.emplace(name, std::move(text));
    }
    return texts;
}

std::string kernels_folder() {
    const char* const folder = std::getenv("PELAGE_KERNELS");
    return folder == nullptr ? "" : folder;
}

void log_kernel(const std::string& name) {
    const char* const file = std::getenv("PELAGE_KERNELS_LOG");
    if (file != nullptr) std::ofstream(file, std::ios::app) << name << '\n';
}

const std::map<std::string, std::string>& kernel_sources() {
    if (kernels_folder().empty()) return embedded_kernels();
    static const auto& of_folder = *new const std::map<std::string, std::string>(read_kernels(kernels_folder()));
    return of_folder;
}

}  // namespace pelage
